"""The kinds of studies, by name."""

from swarmgrasp.simulation.study.gusts import Gusts
from swarmgrasp.simulation.study.losses import Losses
from swarmgrasp.simulation.study.sizes import Sizes
from swarmgrasp.simulation.study.story import Story
from swarmgrasp.simulation.study.study import Study
from swarmgrasp.simulation.study.together import PlacedTogether

KINDS: dict[str, type[Study]] = {
    study.kind: study for study in (Sizes, Losses, PlacedTogether, Gusts, Story)
}
