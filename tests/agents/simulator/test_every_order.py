"""All orders of messages, losses and kills, for two and three robots, on the rules of arrival."""

import pytest

from every_order import Search, all_attached
from swarmgrasp.agents.protocol import Phase


@pytest.mark.parametrize(("robots", "spots", "again"), [(2, 2, 0), (2, 2, 1), (2, 1, 1)])
def test_no_order_of_messages_lets_two_fasten_at_one_spot(robots, spots, again):
    """Whatever comes late or never; and if all comes, each has a spot, as far as there are any."""
    search = Search(robots, spots, again=again)
    ends = search.run()
    assert search.states > 70
    for end in ends:
        attached = [r for r in search.records(end) if r.phase is Phase.ATTACHED]
        assert len(attached) == min(robots, spots)
        assert all_attached(search, end) == (robots == spots)


@pytest.mark.long
def test_no_order_lets_three_fasten_at_one_spot():
    """Seventy thousand states of three robots and a single spot."""
    search = Search(3, 1)
    ends = search.run()
    assert search.states > 50_000
    for end in ends:
        assert sum(r.phase is Phase.ATTACHED for r in search.records(end)) == 1
