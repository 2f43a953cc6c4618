"""Text that others wrote, made safe to show."""


def clean(text: str) -> str:
    r"""Return text on one line without control characters, so that no name can play tricks.

    Examples
    --------
    >>> clean("Zoë\n\x1b[31m")
    'Zoë\\n\\x1b[31m'
    """
    if text.isprintable():
        return text
    return "".join(c if c.isprintable() else repr(c)[1:-1] for c in text)
