"""Compiled kernels: floats, arrays and status codes; they check nothing and never raise."""
