"""The same object and robots in MuJoCo: a judge that shares nothing with us, and floors to push on.

Nothing here knows wind, drag or added masses: MuJoCo is rigid bodies, their forces, and contacts.
"""

from swarmgrasp.simulation.mujoco.judge import Judgement, Trial, judge
from swarmgrasp.simulation.mujoco.model import Floor, mjcf
from swarmgrasp.simulation.mujoco.world import World

__all__ = ["Floor", "Judgement", "Trial", "World", "judge", "mjcf"]
