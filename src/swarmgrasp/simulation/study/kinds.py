"""The kinds of studies, by name."""

from swarmgrasp.simulation.study.sizes import Sizes
from swarmgrasp.simulation.study.study import Study

KINDS: dict[str, type[Study]] = {study.kind: study for study in (Sizes,)}
