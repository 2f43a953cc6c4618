"""The table of sensitivities, and the same as data."""

import numpy as np

from swarmgrasp import sensitivities
from swarmgrasp.cli.show.change import telling_of
from swarmgrasp.cli.show.report import Report
from swarmgrasp.cli.show.sensitivities import show_sensitivities
from swarmgrasp.scenario import load_example
from swarmgrasp.terms import SI


def test_a_row_per_robot_in_the_units_of_the_headings(capsys):
    """Both ways of shifting, turning and strengthening."""
    found = sensitivities(load_example("deck-barge").swarm)
    show_sensitivities(Report(), found, telling_of(SI, found.swarm, []))
    lines = capsys.readouterr().out.splitlines()
    heading, *rows = lines[2:8]
    assert "along - [kN/m]  along + [kN/m]  to - [kN/deg]  to + [kN/deg]" in heading
    castor = next(row.split() for row in rows if row.startswith("Castor"))
    assert castor == ["Castor", "-6.622", "6.622", "8.415", "-8.415", "0", "0"]
    assert "- clockwise, + counter-clockwise" in lines[-1]


def test_a_ridge_is_told_and_thrusters_do_not_move(capsys):
    """Empty cells for what cannot move, and why both ways may be worse."""
    found = sensitivities(load_example("supply-vessel").swarm)
    show_sensitivities(Report(), found, telling_of(SI, found.swarm, []))
    assert "8 directions are equally weak" in capsys.readouterr().out
    assert all(slopes["contact"] == [None, None] for slopes in found.to_data().values())


def test_data_are_in_si_units():
    """Per metre, radian and newton."""
    found = sensitivities(load_example("deck-barge").swarm)
    data = found.to_data()
    assert list(data) == [robot.name for robot in found.swarm.robots]
    for name in ("contact", "direction", "limit"):
        told = [slopes[name] for slopes in data.values()]
        np.testing.assert_array_equal(told, getattr(found, name))
