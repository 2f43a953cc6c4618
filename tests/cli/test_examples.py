import json

from swarmgrasp.scenario import example_names, example_text, scenario_schema


def test_lists_every_example(run):
    """One line each, with the number of robots."""
    status, said, _ = run("examples")
    listed = said.splitlines()[1 : len(example_names()) + 1]
    assert status == 0
    assert tuple(line.split()[0] for line in listed) == example_names()


def test_prints_one(run):
    """`examples NAME > my.yaml` gives exactly the file."""
    assert run("examples", "deck-barge") == (0, example_text("deck-barge"), "")


def test_writes_all_or_nothing(run, tmp_path):
    """Existing files are kept, and then nothing is written, unless forced."""
    tmp_path = tmp_path / "new" / "folder"
    assert run("examples", "model-ship", "--write", tmp_path)[0] == 0
    kept = tmp_path / "model-ship.yaml"
    kept.write_text("mine")
    status, said, complaints = run("examples", "--write", tmp_path)
    assert (status, said) == (2, "")
    assert complaints == f"{kept}: exists already; --force overwrites it\n"
    assert [path.name for path in tmp_path.iterdir()] == ["model-ship.yaml"]
    assert kept.read_text() == "mine"
    assert run("examples", "--write", tmp_path, "--force")[0] == 0
    assert kept.read_text() == example_text("model-ship")
    assert len(list(tmp_path.iterdir())) == len(example_names())


def test_a_near_miss_is_answered_with_the_name(run):
    """A mistyped name is a fault with a suggestion."""
    status, said, complaints = run("examples", "deck-brage")
    assert (status, said) == (2, "")
    assert "did you mean 'deck-barge'?" in complaints
    status, said, complaints = run("quality", "deck-brage")
    assert (status, said) == (2, "")
    assert "did you mean 'deck-barge'?" in complaints


def test_prints_the_schema(run):
    """The schema is JSON alone."""
    status, said, complaints = run("schema")
    assert (status, complaints) == (0, "")
    assert json.loads(said) == json.loads(json.dumps(scenario_schema()))
