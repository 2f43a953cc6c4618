"""What meets those who look around: the package's names, its version, objects in a line."""

import inspect

import pytest

import swarmgrasp as sg
from swarmgrasp.scenario import load_example


def test_the_package_shows_its_public_names_and_no_room() -> None:
    """And its version is that of what is installed."""
    assert set(dir(sg)) == {*sg.__all__, "__version__"}
    assert not [name for name in sg.__all__ if inspect.ismodule(getattr(sg, name))]
    assert sg.__version__.count(".") == 2
    with pytest.raises(AttributeError, match="no attribute 'nonsense'"):
        _ = sg.nonsense


@pytest.mark.parametrize("name", ["quality", "losses", "sensitivities", "place", "qualities_with"])
def test_a_misspelt_keyword_names_the_function_that_was_called(name: str) -> None:
    """And what was probably meant."""
    swarm = load_example("rectangle-5").swarm
    given = ([swarm.robots[0].contact], [0.0]) if name == "qualities_with" else ()
    told = rf"^{name}\(\) got an unexpected keyword argument 'loosing'; did you mean 'losing'\?$"
    with pytest.raises(TypeError, match=told):
        getattr(sg, name)(swarm, *given, loosing=1)


def test_objects_and_answers_are_told_in_a_line_or_two() -> None:
    """However many robots and corners there are."""
    asked = load_example("deck-barge")
    answers = [
        asked,
        asked.problem(),
        asked.swarm,
        asked.swarm.outline,
        sg.place(asked.problem()),
        sg.quality(asked.swarm),
        sg.sensitivities(asked.swarm),
        sg.forces(asked.swarm, (1.0, 0.0, 0.0)),
        sg.capability(asked.swarm, asked.environment, bearings=[0.0, 1.0, 2.0, 3.0, 4.0]),
    ]
    for answer in answers:
        assert "\n" not in repr(answer)
        assert len(repr(answer)) < 500, repr(answer)
        assert repr(answer).startswith(f"{type(answer).__name__}(")
    assert repr(asked.swarm).startswith("Swarm(outline=<Outline>, contacts=<5 x 2 numbers>")
