"""All that can happen to a few agents, in every order: a search of all states, none left out.

Each agent is the real one. What an agent in one state does at one event is worked out once, on a
copy, and looked up from then on; so a state of the whole is a few numbers, and millions are seen.
A message may come at any time or never, so every order, every delay and every loss is among them.
"""

import copy

import msgspec

from swarmgrasp.agents.protocol import Agent, Phase, Place, Settings
from swarmgrasp.agents.protocol import events as ev
from swarmgrasp.agents.protocol.record import LIVES
from swarmgrasp.agents.protocol.wire import Ack, Put, encode

LONG = 20_000.0
"""Longer than anything here lasts: beats, silence and patience do not matter [s]."""
DELIVER, ARRIVE, TOUCH, CRASH, FORGET, ASK_AGAIN = range(6)


class Spots:
    """A planner of a few spots: a robot takes the first that is free."""

    mission, present, fewest = "spots", (), 1

    def __init__(self, count):
        self.spots = [Place(float(k), 0.0, 0.0) for k in range(count)]

    def place(self, rows, obstacles, _):
        """Return the first free spot."""
        taken = [*(row.place for row in rows), *obstacles]
        return next((spot for spot in self.spots if spot not in taken), None)

    def lower(self, rows):
        """Return how many robots there are, and one more: joint plans are never due."""
        return 1.0 + len(rows)

    def is_clear(self, place, others):
        """Tell whether a spot is free."""
        return place not in others

    def measured(self, place):
        """Return the place."""
        return place

    def who(self, _):
        """All are alike."""
        return

    def fault(self, _):
        """All can be."""
        return ""


class Search:
    """The states of some robots that all go to one spot, none having heard of the others' wish.

    Parameters
    ----------
    count : int
        Robots.
    spots : int
        Places.
    crashes : int
        Processes that may be killed, at any time, with what they have kept or without.
    again : int
        How often each may ask once more.
    """

    def __init__(self, count, spots, crashes=0, again=0):
        self.names = [f"R{k + 1}" for k in range(count)]
        self.planner, self.crashes, self.again = Spots(spots), crashes, again
        self.settings = Settings(
            beat=LONG, silent=3.1 * LONG, forget=4.0 * LONG, hold=3.5 * LONG, ask=0.001,
            retry=0.001, gather=0.0, worth=0.0, roster=tuple(self.names),
        )  # fmt: skip
        self._agents, self._numbers, self._done = [], {}, {}
        self._messages, self._message_numbers = [], {}
        self.states = 0

    def run(self, most=10_000_000):
        """See all states; return the ends, those in which nothing is left to happen.

        Raises
        ------
        AssertionError
            With the way to it, if two robots are at one spot.
        """
        begin = self._begin()
        came_from, todo, ends = {begin: None}, [begin], []
        while todo:
            state = todo.pop()
            self._check(state, came_from)
            nexts = list(self._nexts(state))
            if not nexts:
                ends.append(state)
            for what, after in nexts:
                if after not in came_from:
                    came_from[after] = (state, what)
                    todo.append(after)
            self.states = len(came_from)
            assert self.states <= most, f"more than {most} states"
        return ends

    def records(self, state):
        """Return what each robot says of itself in a state."""
        return [self._agents[number].record for number, *_ in state[0]]

    # A state: of each robot (agent, is on its way, claim, holds, times left to ask again); the
    # messages on their way; crashes left; starts so far.

    def _begin(self):
        """Return the state in which all go to the first spot."""
        robots, mail = [], set()
        agents = [
            Agent(n, self.planner, self.settings, incarnation=LIVES + k)
            for k, n in enumerate(self.names)
        ]
        for agent in agents:
            agent.handle(0.0, ev.Start())
        for agent in agents:  # all know that the others are there, and have listened
            for other in agents:
                if other is not agent:
                    agent.memory.merge(other.record)
                    agent.hearing.hear(other.name)
            for k in range(8):
                agent.handle(0.5 * LONG * k, ev.Tick())
        for agent in agents:
            agent.handle(3.5 * LONG, ev.Join())
            effects = agent.handle(3.5 * LONG + 0.002, ev.Tick())
            assert any(isinstance(effect, ev.Go) for effect in effects)
            index = len(robots)
            robots.append((self._number(agent), True, None, False, self.again))
            self._post(index, effects, mail)
        return tuple(robots), frozenset(mail), self.crashes, 0

    def _nexts(self, state):
        """Yield all that can happen next, and what comes of it."""
        robots, mail, crashes, _ = state
        for to, number in mail:
            sender, message, direct = self._messages[number]
            event = ev.Received(sender, message, direct)
            left = mail - {(to, number)}
            yield (DELIVER, to, number), self._after(state, to, event, left)
        for k, (agent, is_under_way, claim, holds, again) in enumerate(robots):
            record = self._agents[agent].record
            if is_under_way:
                yield (ARRIVE, k), self._after(state, k, ev.AtPlace(), mail)
            if claim is not None and not holds:
                yield (TOUCH, k), self._after(state, k, ev.Fastened(claim), mail)
            if again and record.asks:
                yield (ASK_AGAIN, k), self._after(state, k, None, mail)
            if crashes:
                for forgets in (False, True):
                    for completes in {False, claim is not None and not holds}:
                        after = self._crashed(state, k, mail, forgets=forgets, completes=completes)
                        yield (FORGET if forgets else CRASH, k, completes), after

    def _after(self, state, k, event, mail):
        """Return the state after a robot has taken an event."""
        robots, _, crashes, starts = state
        mail = set(mail)
        agent, is_under_way, claim, holds, again = robots[k]
        again -= event is None
        new, effects = self._handle(agent, event)
        if isinstance(event, ev.AtPlace):
            is_under_way = False
        if isinstance(event, ev.Fastened):
            holds = True
        for effect in effects:
            if isinstance(effect, ev.Go):
                is_under_way = True
            elif isinstance(effect, ev.Halt):
                is_under_way = False
            elif isinstance(effect, ev.Fasten):
                claim = effect.place
        self._post(k, effects, mail)
        changed = (*robots[:k], (new, is_under_way, claim, holds, again), *robots[k + 1 :])
        if not crashes:
            mail = [key for key in mail if not self._is_stale(changed, *key)]
        return changed, frozenset(mail), crashes, starts

    def _is_stale(self, robots, to, number):
        """Tell whether a message changes nothing any more, whenever it comes."""
        agent, (_, message, _) = self._agents[robots[to][0]], self._messages[number]
        if not isinstance(message, Put | Ack):
            return False
        known = agent.memory.get(message.record.id)
        if known is None:
            return False
        if isinstance(message, Ack) and message.of == agent.record.asks_for:
            return not agent.record.asks and known.version >= message.record.version
        asks = isinstance(message, Put) and message.record.asks
        return known.version > message.record.version or (known == message.record and not asks)

    def _crashed(self, state, k, mail, *, forgets, completes):
        """Return the state after a robot's process was killed and began again."""
        robots, _, crashes, starts = state
        mail = set(mail)
        agent, _, claim, holds, again = robots[k]
        holds = holds or completes
        claim = claim if holds else None
        old, starts = self._agents[agent], starts + 1
        kept = None if forgets else old.state
        incarnation = LIVES * (1 if forgets else starts + 1) + 64 * starts + k
        new = Agent(self.names[k], self.planner, self.settings, incarnation=incarnation, state=kept)
        clock = 10.0 * LONG * starts
        effects = new.handle(clock, ev.Start(claim))
        effects += new.handle(clock, ev.Join())
        effects += new.handle(clock + 0.002, ev.Tick())
        for step in range(1, 8):  # it listens for as long as it takes
            effects += new.handle(clock + 0.5 * LONG * step, ev.Tick())
        goes = any(isinstance(effect, ev.Go) for effect in effects)
        self._post(k, effects, mail)
        changed = (self._number(new), goes, claim, holds, again)
        return (
            (*robots[:k], changed, *robots[k + 1 :]), frozenset(mail), crashes - 1, starts
        )  # fmt: skip

    def _handle(self, number, event):
        """Return what an agent in a state is after an event, and what it wants done."""
        key = number, event if not isinstance(event, ev.Received) else (
            event.sender, encode(event.message), event.is_direct
        )  # fmt: skip
        if key not in self._done:
            agent = self._copy(number)
            clock = agent.hearing.clock_at(agent.hearing.now)
            if event is None:
                effects = agent.handle(clock + 0.002, ev.Tick())
            else:
                effects = agent.handle(clock, event)
            self._done[key] = self._number(agent), effects
        return self._done[key]

    def _post(self, k, effects, mail):
        """Put what a robot sends on its way."""
        for effect in effects:
            if isinstance(effect, ev.Send):
                others = [j for j in range(len(self.names)) if j != k]
                if effect.to == ev.ANYONE:
                    others = others[:1]
                elif effect.to != ev.EVERYONE:
                    others = [self.names.index(effect.to)]
                key = self.names[k], encode(effect.message), effect.to != ev.EVERYONE
                number = self._message_numbers.setdefault(key, len(self._messages))
                if number == len(self._messages):
                    self._messages.append((self.names[k], effect.message, key[2]))
                for j in others:
                    mail.add(
                        (j, number)
                    )  # twice the same is once: whatever comes late may not come

    def _copy(self, number):
        """Return a copy of an agent, which shares what never changes."""
        shared = {id(self.planner): self.planner, id(self.settings): self.settings}
        return copy.deepcopy(self._agents[number], shared)

    def _number(self, agent):
        """Return the number of an agent's state: equal ones have one."""
        seen = {id(self.planner), id(self.settings)}
        key = repr(_plain(agent, seen))
        if key not in self._numbers:
            self._numbers[key] = len(self._agents)
            self._agents.append(agent)
        return self._numbers[key]

    def _check(self, state, came_from):
        """Check that no two are at one spot, or about to be."""
        claims = [claim for _, _, claim, _, _ in state[0] if claim is not None]
        if len(set(claims)) < len(claims):
            way = []
            while came_from[state] is not None:
                state, what = came_from[state]
                way.append(what)
            told = [
                (*what[:2], self._messages[what[2]][:2]) if what[0] == DELIVER else what
                for what in reversed(way)
            ]
            raise AssertionError("two at one spot:\n" + "\n".join(map(str, told)))


def _plain(thing, seen):
    """Return all that an agent's next acts depend on, as plain values in a fixed order."""
    if isinstance(thing, msgspec.Struct):
        return msgspec.msgpack.encode(thing)
    if isinstance(thing, dict):
        return [(str(key), _plain(value, seen)) for key, value in sorted(thing.items())]
    if isinstance(thing, set | frozenset):
        return sorted(map(str, thing))
    if isinstance(thing, list | tuple):
        return [_plain(each, seen) for each in thing]
    if hasattr(thing, "__dict__"):
        if id(thing) in seen or type(thing).__name__ == "Reports":
            return None
        seen.add(id(thing))
        return [(name, _plain(value, seen)) for name, value in sorted(vars(thing).items())]
    return thing


def all_attached(search, state):
    """Tell whether every robot holds the object, each at its own spot."""
    records = search.records(state)
    return all(record.phase is Phase.ATTACHED for record in records)
