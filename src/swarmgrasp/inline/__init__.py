"""What notebooks show of an object: its picture, and the sentences of the command line."""

from swarmgrasp.inline.html import html_of
from swarmgrasp.inline.pictures import figure_of

__all__ = ["figure_of", "html_of"]
