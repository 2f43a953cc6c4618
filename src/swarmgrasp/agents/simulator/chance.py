"""Chance that is the same everywhere: a function of whole numbers, not of who drew before."""

_WHOLE = (1 << 64) - 1


def mixed(*numbers: int) -> int:
    """Return 64 bits that depend on all of some numbers (splitmix64).

    Examples
    --------
    >>> mixed(1, 2) == mixed(1, 2), mixed(1, 2) == mixed(2, 1)
    (True, False)
    """
    bits = 0
    for number in numbers:
        bits = (bits + number + 0x9E3779B97F4A7C15) & _WHOLE
        bits = ((bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9) & _WHOLE
        bits = ((bits ^ (bits >> 27)) * 0x94D049BB133111EB) & _WHOLE
        bits ^= bits >> 31
    return bits


def share_of(bits: int) -> float:
    """Return a number in [0, 1) from the lower 32 of some bits."""
    return (bits & 0xFFFFFFFF) / 4294967296.0


def between(low: float, high: float, *numbers: int) -> float:
    """Return a number between two, as some whole numbers say."""
    return low + (high - low) * share_of(mixed(*numbers))
