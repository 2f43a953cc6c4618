"""Shared modules beside this file can be imported by every test; Hypothesis is repeatable."""

from hypothesis import settings

settings.register_profile("repeatable", deadline=None, derandomize=True)
settings.load_profile("repeatable")
