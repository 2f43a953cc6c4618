"""The colours of animations: those of the pictures."""

BLUE = "#0072B2"
ORANGE = "#E69F00"
VERMILION = "#D55E00"
INK = "#222222"
GREY = "#6E6E6E"
"""Of Okabe and Ito, told apart by every kind of colour vision, and greys."""
WAY = "#C3CAD0"
WATER = "#F5F9FC"
OBJECT = "#DDE2E6"


def shares(colour: str) -> tuple[float, float, float]:
    """Return the red, green and blue of a colour, each from 0 to 1.

    Examples
    --------
    >>> shares("#FF0033")
    (1.0, 0.0, 0.2)
    """
    red, green, blue = (int(colour[i : i + 2], 16) / 255.0 for i in (1, 3, 5))
    return red, green, blue
