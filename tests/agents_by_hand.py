"""A few agents by hand: what each sends is kept, and handed on when a test says so."""

import functools
import math

from swarmgrasp import Newcomer, Outline, Problem, Robot, Stretch, Swarm, Zone
from swarmgrasp.agents.protocol import Agent, ProblemPlanner, Settings
from swarmgrasp.agents.protocol import events as ev
from swarmgrasp.agents.protocol.record import LIVES
from swarmgrasp.agents.protocol.wire import decode, encode

BARGE = Outline([(-20, -5), (20, -5), (20, 5), (-20, 5)])


@functools.cache
def planner(present=4, spacing=4.0, zone=None):
    """Return a mission: a barge that pushing robots hold, and others that are to come."""
    held = [
        Robot((-10.0, -5.0), math.pi / 2, 1.0, "A1"),
        Robot((12.0, 5.0), -math.pi / 2, 1.0, "A2"),
        Robot((-20.0, 2.0), 0.0, 1.0, "A3"),
        Robot((20.0, -1.0), math.pi, 1.0, "A4"),
    ]
    zones = None if zone is None else (Zone(Stretch(*zone)),)
    swarm = Swarm(BARGE, held[:present])
    return ProblemPlanner(Problem(swarm, Newcomer(1.0, "push", 0.5), zones, spacing=spacing))


class Crew:
    """Agents, the messages between them, and a clock."""

    def __init__(self, *names, mission=None, settings=None, **more):
        self.planner = mission or planner()
        self.clock, self.post, self.effects, self.log = 0.0, [], {}, []
        settings = settings or Settings(gather=0.0, worth=0.0)
        self.agents = {
            name: Agent(name, self.planner, settings, incarnation=LIVES + k, **more)
            for k, name in enumerate(names)
        }
        for name in names:
            self.tell(name, ev.Start())
        self.deliver()

    def __getitem__(self, name):
        return self.agents[name].record

    def tell(self, name, event):
        """Tell an agent of an event, and put what it sends into the post."""
        effects = self.agents[name].handle(self.clock, event)
        self.effects[name] = [e for e in effects if not isinstance(e, ev.Send)]
        self.log += [(name, effect) for effect in self.effects[name]]
        for effect in effects:
            if isinstance(effect, ev.Send):
                others = [n for n in self.agents if n != name]
                to = others if effect.to == ev.EVERYONE else others[:1]
                to = to if effect.to in {ev.EVERYONE, ev.ANYONE} else [effect.to]
                data = encode(effect.message)
                direct = effect.to != ev.EVERYONE
                self.post += [(n, ev.Received(name, decode(data), direct)) for n in to]
        return self.effects[name]

    def deliver(self, among=None, keep=lambda _: False):
        """Hand over all messages, and those that come of it, between some robots or all."""
        held = []
        while self.post:
            to, event = self.post.pop(0)
            if keep((event.sender, to, event.message)):
                held.append((to, event))
            elif to in self.agents and (among is None or {to, event.sender} <= set(among)):
                self.tell(to, event)
        self.post = held

    def wait(self, seconds, among=None, step=0.25):
        """Let time pass: ticks and messages."""
        end = self.clock + seconds
        while self.clock < end:
            self.clock = min(self.clock + step, end)
            for name in list(self.agents):
                self.tell(name, ev.Tick())
            self.deliver(among)

    def join(self, *names):
        """Let robots join, one after the other."""
        for name in names:
            self.tell(name, ev.Join())
            self.deliver()
            self.wait(1.0)

    def attach(self, name):
        """Let a robot travel, arrive, be confirmed and fasten, as fast as the rules allow."""
        self.tell(name, ev.AtPlace())
        self.deliver()
        for _ in range(40):
            if any(isinstance(e, ev.Fasten) for e in self.effects[name]):
                break
            self.wait(0.25)
        self.tell(name, ev.Fastened(self[name].place))
        self.deliver()


def kinds(effects):
    """Return the kinds of effects, in order."""
    return [type(effect).__name__ for effect in effects if not isinstance(effect, ev.Report)]


def told(effects):
    """Return what was reported, as words for programs."""
    return [effect.what for effect in effects if isinstance(effect, ev.Report)]
