import assert from "node:assert/strict";
import { test } from "node:test";

import type { Pair } from "../src/messages";
import { gapsOf, isAllRound, withEnd, withGaps, withNewGap } from "../src/plan/gaps";
import { overlap, placed, type Wanted } from "../src/plan/labels";
import { newRobot } from "../src/plan/adding";
import { moveEnd } from "../src/plan/moves";
import { withCorner, withNewCorner, withoutCorner } from "../src/plan/outline";
import { reachOf } from "../src/plan/reach";
import { Screen } from "../src/plan/screen";
import { distance, Shape } from "../src/plan/shape";
import { MOST_OFF, movedAlong, movedInside, stanceOf, turnedOff, turnedTo } from "../src/plan/stance";
import { BARGE, dice, doc, near, robot } from "./helped";

const SHAPE = new Shape(BARGE);

test("no point of the outline is nearer than the nearest", () => {
  const roll = dice(1);
  for (let i = 0; i < 200; i += 1) {
    const point: Pair = [120 * roll() - 60, 60 * roll() - 30];
    const found = SHAPE.nearest(point);
    assert.ok(distance(SHAPE.placeAt(found.along).at, found.at) < 1e-9);
    for (let k = 0; k < 400; k += 1) {
      assert.ok(distance(point, SHAPE.placeAt((k / 400) * SHAPE.perimeter).at) >= found.distance - 1e-9);
    }
  }
});

test("a stretch is cut at the corners, and across the first of them", () => {
  assert.deepEqual(SHAPE.pieces(50, 70).map(({ edge }) => edge), [0, 1]);
  assert.deepEqual(SHAPE.pieces(150, 10).map(({ edge, start, end }) => [edge, start, end]), [[3, 150, 160], [0, 160, 170]]);
  assert.deepEqual(SHAPE.pieces(20, 20), []);
});

test("a push keeps its angle to the side round a corner; a line keeps where it leads, outside", () => {
  const push = robot([0, -10], Math.PI / 2 + 0.2);
  const moved = movedAlong(SHAPE, push, 70);
  assert.deepEqual(moved.contact, [30, 0]);
  assert.ok(near(moved.direction, -Math.PI + 0.2));
  const pull = robot([0, -10], -Math.PI / 2 + 0.3);
  assert.ok(near(movedAlong(SHAPE, pull, 70).direction, -Math.PI / 2 + 0.3));
  assert.ok(near(Math.abs(stanceOf(SHAPE, movedAlong(SHAPE, pull, 110)).off), MOST_OFF));
});

test("a robot at a corner stands on the side that it is squarer to", () => {
  assert.equal(stanceOf(SHAPE, robot([30, -10], Math.PI / 2)).edge, 0);
  assert.equal(stanceOf(SHAPE, robot([30, -10], Math.PI)).edge, 1);
});

test("turning is square within three degrees, in fives with Shift, and never past the side", () => {
  const push = robot([0, -10], Math.PI / 2);
  const degree = Math.PI / 180;
  assert.ok(near(turnedTo(SHAPE, push, 92 * degree, false).direction, Math.PI / 2));
  assert.ok(near(turnedTo(SHAPE, push, 106 * degree, true).direction, 105 * degree));
  assert.ok(near(turnedOff(SHAPE, push, 3).direction, Math.PI / 2 + MOST_OFF));
});

test("sectors turn with their robot", () => {
  const made = robot([0, -10], Math.PI / 2, { sectors: [[1, 2]] });
  assert.deepEqual(movedAlong(SHAPE, made, 110).sectors!.map(([start]) => near(start, 1 - Math.PI)), [true]);
});

test("a mounted robot stays in the hull", () => {
  const made = robot([0, 0], 0, { mounted: true });
  assert.deepEqual(movedInside(SHAPE, made, [5, 5]).contact, [5, 5]);
  assert.deepEqual(movedInside(SHAPE, made, [5, 25]).contact, [5, 10]);
});

test("the ends of a stretch do not pass each other, also across the first corner", () => {
  const problem = { ...doc([]).problem, no_go: [{ start: 150, end: 10, name: "" }] };
  const grip = { kind: "no-go", index: 0, end: "end" } as const;
  assert.deepEqual(moveEnd(SHAPE, problem, grip, 5).no_go[0], { start: 150, end: 5, name: "" });
  assert.deepEqual(moveEnd(SHAPE, problem, grip, 140).no_go[0], { start: 150, end: 10, name: "" });
});

test("a new robot goes where there is most room", () => {
  const made = newRobot(SHAPE, doc([robot([0, -10], Math.PI / 2), robot([0, 10], -Math.PI / 2)]), "Tug");
  assert.ok(Math.abs(Math.abs(made.contact[0]) - 30) < 1e-9 && Math.abs(made.contact[1]) < 1e-9);
  assert.equal(made.name, "Tug 3");
});

test("another outline keeps robots on their edge, at their share of it", () => {
  const before = doc([robot([-15, -10], Math.PI / 2), robot([30, 5], Math.PI)]).problem;
  const wider = withCorner(before, 1, [90, -10]);
  assert.deepEqual(wider.swarm.robots[0]!.contact, [0, -10]);
  const split = withNewCorner(before, 0);
  assert.deepEqual(split.swarm.outline.vertices[1], [0, -10]);
  assert.ok(distance(split.swarm.robots[0]!.contact, [-15, -10]) < 1e-9);
  assert.ok(distance(split.swarm.robots[1]!.contact, [30, 5]) < 1e-9);
  const joined = withoutCorner(split, 1);
  assert.deepEqual(joined.swarm.outline.vertices, BARGE.vertices);
  assert.ok(distance(joined.swarm.robots[0]!.contact, [-15, -10]) < 1e-9);
  assert.ok(near(wider.swarm.outline.origin[0], 16 + 2 / 3));
});

test("what a robot can exert ends at its limits", () => {
  const sizes = (more: Parameters<typeof robot>[2]): number[] =>
    reachOf(robot([0, 0], 0.3, more)).map((corners) => Math.max(...corners.map(([x, y]) => Math.hypot(x, y))));
  assert.deepEqual(sizes({}), []);
  assert.ok(near(sizes({ steers: 0.5 })[0]!, 100));
  assert.ok(near(sizes({ steers: 0.5, reverse_limit: 40 })[1]!, 40));
  assert.ok(near(sizes({ friction: 0.75 })[0]!, 125));
  assert.equal(sizes({ sectors: [[0, 1], [2, 3]] }).length, 2);
});

test("the card turns the bow up when it is tall, and pixels come back as metres", () => {
  for (const [width, height] of [[900, 500], [390, 480]] as const) {
    const screen = new Screen(SHAPE, width, height);
    assert.equal(screen.turned, width < height);
    const back = screen.model(screen.at([12, -7]));
    assert.ok(distance(back, [12, -7]) < 1e-9);
    const bow = screen.at([30, 0]);
    assert.ok(screen.turned ? bow[1] < height / 2 : bow[0] > width / 2);
  }
});

test("names that may be left out cover neither each other nor what is kept", () => {
  const roll = dice(7);
  for (let round = 0; round < 30; round += 1) {
    const wanted = Array.from({ length: 30 }, (_, i): Wanted => ({
      key: String(i), end: [800 * roll(), 500 * roll()], angle: 6.28 * roll(), width: 30 + 50 * roll(), height: 32,
      off: 9, optional: true, inside: false,
    }));
    const kept = [{ left: 0, top: 0, right: 200, bottom: 90 }];
    const hull = { left: 300, top: 200, right: 500, bottom: 300 };
    const found = placed(wanted, { width: 800, height: 500, kept, hull, sides: [], arrows: [] }, new Map());
    assert.ok(found.length > 5);
    found.forEach((one, i) => {
      assert.ok(!overlap(one.box, kept[0]!) && !overlap(one.box, hull));
      for (const other of found.slice(i + 1)) assert.ok(!overlap(one.box, other.box));
    });
  }
});

// -- gaps --------------------------------------------------------------------------------------

test("a thruster pushes all round but for its gaps, and those that meet are one", () => {
  const turn = 2 * Math.PI;
  const azimuth = { ...robot([0, 0], 0), mounted: true, steers: Math.PI };
  assert.ok(isAllRound(azimuth));
  assert.deepEqual(gapsOf(azimuth), []);
  const one = withGaps(azimuth, [[1, 2]]);
  assert.equal(one.steers, 0);
  assert.deepEqual(one.sectors, [[2, 1 + turn]]);
  assert.ok(near(one.direction, (3 + turn) / 2));
  assert.deepEqual(gapsOf(one), [[1 + turn, 2 + turn]]);
  assert.ok(isAllRound(one));
  const two = withGaps(azimuth, [[1, 2], [1.5, 3], [5, 5.5]]);
  assert.deepEqual(two.sectors, [[3, 5], [5.5, 1 + turn]]);
  assert.deepEqual(withGaps(two, []), { ...two, sectors: null, steers: Math.PI });
  assert.deepEqual(withGaps(azimuth, [[6, 6.5], [6.4, 7]]).sectors!.length, 1);
});

test("an end of a gap that is moved stops before the other, and one that is typed may pass it", () => {
  const degrees = (gap: readonly number[]): number[] => gap.map((angle) => Math.round((angle * 180) / Math.PI));
  const at = (angle: number): number => (angle * Math.PI) / 180;
  const gap: [number, number] = [at(170), at(200)];
  assert.deepEqual(degrees(withEnd(gap, 1, at(175), true)), [170, 175]);
  assert.deepEqual(degrees(withEnd(gap, 1, at(165), true)), [170, 200]);
  assert.deepEqual(degrees(withEnd(gap, 1, at(165), false)), [170, 525]);
  assert.deepEqual(degrees(withEnd(gap, 0, at(-160), false)), [200, 200]);
  assert.deepEqual(degrees(withEnd(gap, 0, at(90), true)), [90, 200]);
});

test("another gap comes in the middle of the widest sector", () => {
  const azimuth = { ...robot([0, 0], 0), mounted: true, steers: Math.PI };
  const first = withNewGap(azimuth);
  const second = withNewGap(first);
  assert.equal(gapsOf(first).length, 1);
  assert.equal(gapsOf(second).length, 2);
  const [a, b] = second.sectors!.map(([start, end]) => end - start);
  assert.ok(near(a!, b!));
});
