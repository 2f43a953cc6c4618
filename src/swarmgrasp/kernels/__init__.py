"""The kernels, in C: floats and arrays in, numbers and bytes out; `core` is the compiled module."""
