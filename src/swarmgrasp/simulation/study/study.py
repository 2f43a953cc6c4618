"""What a study is: runs that are alike but for their seeds, and what they tell."""

import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.plain import Plain, Told
from swarmgrasp.terms import SI, Terms

Seeds = NDArray[np.int64]
Ask = Callable[[str], list[tuple[Any, ...]]]
"""Puts a question in SQL to the table `runs`, whose rows are those runs that have no fault."""

ENOUGH = 20
"""Seeds of a batch that its draws hang on. With thousands, making the source of chance takes as
long as what is drawn from it."""


class Column(NamedTuple):
    """What every run of a study tells.

    Attributes
    ----------
    type : {"count", "number", "flag"}
    unit : str
        "" for what has none.
    words : str
        What it is.
    """

    type: Literal["count", "number", "flag"]
    unit: str
    words: str


class ColumnHead(NamedTuple):
    """The heading of a column of what is found.

    Attributes
    ----------
    words : str
    unit : str
        "" for what has none. Values are in SI: if it is "%", shares are shown in percent; if it is
        "deg", radians in degrees.
    """

    words: str
    unit: str = ""


@dataclass(frozen=True)
class Findings(Told):
    """What a study has found.

    Attributes
    ----------
    headline : str
        The answer in a sentence, in the terms that were asked for.
    headings : tuple of ColumnHead
        Of the columns.
    rows : tuple of tuple of float
        In SI units; nan where there is nothing to tell.
    """

    headline: str
    headings: tuple[ColumnHead, ...]
    rows: tuple[tuple[float, ...], ...]


class Study(Plain, ABC):
    """Runs that are alike but for their seeds; what they are is in the fields of each kind.

    Attributes
    ----------
    kind : str
        Its name.
    question : str
        What it asks, in a few words.
    batch : int
        Runs that are measured at once. They have what they draw in common, so that the same seeds
        in other batches are other runs.
    size : int
        Runs in a shard: what one process does in some seconds.
    columns : mapping of str to Column
        What each run tells.
    """

    kind: ClassVar[str]
    question: ClassVar[str]
    batch: ClassVar[int]
    size: ClassVar[int]
    columns: ClassVar[Mapping[str, Column]]

    @abstractmethod
    def words(self, terms: Terms = SI) -> str:
        """Say what its runs are, in a few words."""

    @abstractmethod
    def measure(self, seeds: Seeds) -> Mapping[str, ArrayLike]:
        """Measure runs.

        Parameters
        ----------
        seeds : (k,)
            One for each run, at least 0; at most as many as a batch has.

        Returns
        -------
        mapping of str to (k,)
            What the runs tell, by column; nan where there is nothing to tell.
        """

    @abstractmethod
    def find(self, ask: Ask, terms: Terms = SI) -> Findings:
        """Sum up the runs: in SI units, but for the headline."""


def told_rows(rows: Sequence[tuple[float | None, ...]]) -> tuple[tuple[float, ...], ...]:
    """Return rows of an answer in SQL as numbers, null as nan."""
    return tuple(tuple(math.nan if value is None else value for value in row) for row in rows)


def in_words(headings: Sequence[ColumnHead], terms: Terms) -> tuple[ColumnHead, ...]:
    """Return headings with what robots are called for `{robots}`."""
    return tuple(head._replace(words=head.words.format(robots=terms.several)) for head in headings)


def draws_of(seeds: Seeds) -> np.random.Generator:
    """Return the source of what a batch has in common."""
    return np.random.default_rng(seeds[:ENOUGH])
