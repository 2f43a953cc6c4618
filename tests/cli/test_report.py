import sys

from swarmgrasp.cli.show.report import Column, Report


def test_a_narrow_terminal_keeps_the_names(monkeypatch, capsys):
    """Spare columns go first, then numbers; what is left out is told, names never."""
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True, raising=False)
    monkeypatch.setenv("COLUMNS", "60")
    numbers = [Column(name, is_number=True) for name in ("x [m]", "y [m]", "quality [kN]")]
    columns = [Column("robot"), *numbers, Column("place"), Column("off", is_spare=True)]
    row = ["Fortuna the second", "-123.456", "1.234", "476.92", "port aft pads", "push 1 clockwise"]
    Report().table(columns, [row])
    said = capsys.readouterr().out
    assert "Fortuna the second" in said
    assert "port aft pads" in said
    assert "476.92" in said
    assert "also shows: x [m], y [m], off." in said.replace("\n", " ")
