"""The plain forms of what robots say and know: for streams, logs and pages; SI and radians."""

from typing import Any

from swarmgrasp.agents.protocol.record import Place, Record


def place_data(place: Place | None) -> dict[str, float] | None:
    """Return a place as plain data."""
    if place is None:
        return None
    return {"x": place.x, "y": place.y, "direction": place.direction, "steers": place.steers}


def record_data(record: Record) -> dict[str, Any]:
    """Return what a robot says of itself as plain data.

    Examples
    --------
    >>> from swarmgrasp.agents.protocol.record import Phase
    >>> record_data(Record("Ajax", 1, 2, Phase.LEFT))["phase"]
    'left'
    """
    return {
        "name": record.id,
        "incarnation": record.incarnation,
        "sequence": record.sequence,
        "phase": record.phase.name.lower(),
        "ticket": record.ticket,
        "arrival": record.arrival,
        "place": place_data(record.place),
        "certified": record.lower,
        "gone": [name for name, _ in record.gone],
    }
