"""A hull and its robots in weather: what becomes of them in time."""
