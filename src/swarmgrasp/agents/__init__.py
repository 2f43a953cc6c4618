"""Robots that decide for themselves: each a process of its own, on a network that fails."""
