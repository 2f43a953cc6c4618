"""Members of groups by hand: a loop over time that hands on what they send, and counts it."""

import heapq
import math
from collections import Counter, defaultdict

import numpy as np

from swarmgrasp import Newcomer, Outline, Problem, Swarm
from swarmgrasp.agents.groups import Member, Parts
from swarmgrasp.agents.groups import member as mb
from swarmgrasp.agents.groups import slot as sl
from swarmgrasp.agents.protocol import Settings
from swarmgrasp.agents.protocol import events as ev
from swarmgrasp.agents.protocol.record import Place
from swarmgrasp.agents.protocol.wire import decode, encode

SETTINGS = Settings(beat=1.0, silent=3.5, gather=0.05, worth=0.0)
SPACING = 1.5
ALONG = 2.2
"""Robots at the start stand so far apart along the boundary [m]: far enough around corners too."""


def mission(groups, size):
    """Return a long barge that robots push, and its parts, each with room for so many and more."""
    length = 0.5 * groups * (size + 6) * ALONG
    barge = Outline([(0, 0), (length, 0), (length, 6), (0, 6)])
    problem = Problem(Swarm(barge, []), Newcomer(1.0, "push", 0.5), spacing=SPACING)
    return problem, Parts.of(barge, groups, SPACING)


def places_of(parts, group, count, rng):
    """Return places along a part, at equal distances, in directions drawn at random."""
    part, outline = parts.each[group], parts.outline
    arcs = part.start + (0.5 + np.arange(count)) * ALONG
    contacts = [outline.at_arc_length(float(arc)) for arc in arcs]
    return [Place(*c.point, c.inward + rng.uniform(-0.5, 0.5)) for c in contacts]


class World:
    """Members, the messages between them, and a clock; what each sends is counted in bytes."""

    def __init__(self, problem, parts, seed=1, loss=0.0):
        self.problem, self.parts, self.loss = problem, parts, loss
        self.rng = np.random.default_rng(seed)
        self.members, self.post, self.clock, self.count = {}, [], 0.0, 0
        self.sent, self.received, self.reports = Counter(), Counter(), []
        self.due, self.groups = {}, defaultdict(dict)

    def add(self, name, attached=None):
        """Start a robot's process."""
        self.members[name] = Member(name, self.problem, self.parts, SETTINGS)
        self.put(self.clock, name, ev.Start(attached))

    def put(self, time, name, event):
        """Let an event come."""
        self.count += 1
        heapq.heappush(self.post, (time, self.count, name, event))

    def crash(self, name):
        """End a robot's process."""
        group = self.members.pop(name).group
        self.groups[group].pop(name, None)

    def run(self, until):
        """Let everything happen up to a time [s]."""
        while self.post and self.post[0][0] <= until:
            self.clock, _, name, event = heapq.heappop(self.post)
            member = self.members.get(name)
            if isinstance(event, ev.Tick) and self.due.get(name) != self.clock:
                continue  # it was to wake earlier, and has
            if member is None:
                continue
            if isinstance(event, ev.AtPlace) and member.agent.record.phase != 2:
                continue
            group = member.group
            effects = member.handle(self.clock, event)
            if member.group != group:
                self.groups[group].pop(name, None)
                self.groups[member.group][name] = member
            for effect in effects:
                self.act(name, effect)
            due = max(member.wake, self.clock + 1e-3)
            if not self.clock < self.due.get(name, -1.0) <= due:
                self.due[name] = due
                self.put(due, name, ev.Tick())
        self.clock = until

    def act(self, name, effect):
        """Do what a robot decided, in the world."""
        match effect:
            case mb.Within(group, ev.Send(to, message)):
                data = encode(message)
                peers = self.chosen([n for n in self.groups[group] if n != name], to)
                self.deliver(name, data, peers, mb.Heard(
                    group, ev.Received(name, decode(data), to != ev.EVERYONE)
                ))  # fmt: skip
            case mb.Tell(to, slots):
                data = sl.encode(slots)
                peers = self.chosen([n for n in self.members if n != name], to)
                self.deliver(name, data, peers, mb.SlotsTold(name, sl.decode(data)))
            case mb.Wonder():
                peers = self.chosen([n for n in self.members if n != name], ev.ANYONE)
                self.deliver(name, b"?", peers, mb.Wondered(name))
            case ev.Go():
                self.put(self.clock + 3.0, name, ev.AtPlace())
            case ev.Fasten(place):
                self.put(self.clock + 0.5, name, ev.Fastened(place))
            case ev.Loosen():
                self.put(self.clock + 0.5, name, ev.Loosened())
            case ev.Report():
                self.reports.append((self.clock, name, effect))

    def chosen(self, peers, to):
        """Return who a message is for."""
        if to == ev.EVERYONE:
            return peers
        if to == ev.ANYONE:
            return peers[:1]
        return [to] if to in peers else []

    def deliver(self, name, data, peers, event):
        """Let a message come, by and by; one publication counts once, whoever hears it."""
        if peers:
            self.sent[name] += len(data)
        for peer in peers:
            if self.rng.random() >= self.loss:
                self.received[peer] += len(data)
                self.put(self.clock + self.rng.uniform(0.005, 0.03), peer, event)

    @property
    def swarm(self):
        """All robots that hold the object."""
        records = [m.agent.record for m in self.members.values() if m.agent is not None]
        there = [r.place for r in records if r.phase >= 5]
        contacts = np.array([(p.x, p.y) for p in there]).reshape(-1, 2)
        return Swarm.from_arrays(self.parts.outline, contacts, [p.direction for p in there])

    def nearest(self):
        """Return the least distance of two robots that hold the object [m]."""
        contacts = self.swarm.contacts
        apart = np.linalg.norm(contacts[:, None] - contacts, axis=2)
        np.fill_diagonal(apart, math.inf)
        return float(apart.min())


def begun(groups, size, seed=1, loss=0.0):
    """Return a world in which all groups hold the object, and have told so."""
    problem, parts = mission(groups, size)
    world = World(problem, parts, seed, loss)
    for group in range(groups):
        for k, place in enumerate(places_of(parts, group, size, world.rng)):
            world.add(f"G{group:02d}N{k:02d}", place)
    world.run(8.0)
    return world
