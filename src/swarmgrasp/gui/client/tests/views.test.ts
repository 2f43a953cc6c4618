import assert from "node:assert/strict";
import { test } from "node:test";

import type { LandscapePiece, SlopesPart } from "../src/messages";
import { Shape } from "../src/plan/shape";
import { axisOf, columnsOf, edgeOf, namesOf, offOf, pixelsOf, sectorOn, shortName, valueAt, type Column } from "../src/views/columns";
import { ramp } from "../src/views/paint";
import { calmRim, curve, freeBearing, percentile, polar, rimOf, ringsTo, speedAt } from "../src/views/polar";
import { arrowsOf } from "../src/views/slopes";
import { axesOf, dot, FIRST_EYE, isAlong, rimOf as outlineOf, Solid, turned } from "../src/views/solid";
import { BARGE, dice, doc, near, robot } from "./helped";

const KNOT = 1852 / 3600;
const DEGREE = Math.PI / 180;
const SHAPE = new Shape(BARGE);

// -- the wind rose ---------------------------------------------------------------------------

test("rings are whole steps, four at most, and reach as far as is asked", () => {
  for (let knots = 1; knots < 9000; knots = Math.ceil(knots * 1.07)) {
    const { rim, step } = ringsTo(knots * KNOT, KNOT);
    assert.ok(rim >= knots * KNOT - 1e-9);
    assert.ok(rim / step <= 4 + 1e-9 && near(rim / step, Math.round(rim / step)));
  }
  assert.ok(near(ringsTo(100 * KNOT, KNOT).step, 25 * KNOT));
});

test("one long curve does not make the others a dot, and the wind that is asked about is within", () => {
  const most = [174, 60, 55, 50, 52, 58].map((speed) => speed * KNOT);
  const lost = [90, 45, 40, 38, 39, 44].map((speed) => speed * KNOT);
  assert.ok(near(rimOf({ intact: most, lost, wind: 0 }, KNOT).rim, 80 * KNOT));
  assert.ok(rimOf({ intact: most, lost, wind: 300 * KNOT }, KNOT).rim >= 300 * KNOT);
  assert.ok(rimOf({ intact: [NaN, NaN], lost: [], wind: 0 }, KNOT).rim > 0);
});

test("a rim stays while it differs little, and goes when the wind is beyond it", () => {
  const before = { rim: 100, step: 25 };
  assert.equal(calmRim(before, { rim: 110, step: 50 }, 50, 110), before);
  assert.equal(calmRim(before, { rim: 150, step: 50 }, 120, 150).rim, 150);
  assert.equal(calmRim(before, { rim: 60, step: 20 }, 10, 60).rim, 60);
  assert.equal(calmRim(null, before, 0, 100), before);
});

test("ahead is up and starboard right; a curve is held at the rim and broken where nothing is held", () => {
  assert.ok(polar(0, 5).every((value, i) => near(value, [0, -5][i]!)));
  assert.ok(polar(Math.PI / 2, 5).every((value, i) => Math.abs(value - [5, 0][i]!) < 1e-9));
  const bearings = [0, 1, 2, 3].map((quarter) => (quarter * Math.PI) / 2);
  assert.equal(curve(bearings, [1, 9, 1, 1], 10, 2), "M0.00 -10.00L20.00 -0.00L0.00 10.00L-10.00 0.00Z");
  assert.equal(curve(bearings, [1, NaN, 1, 1], 10, 2), "M0.00 -10.00M0.00 10.00L-10.00 0.00");
  assert.ok(near(speedAt(bearings, [1, 3, 1, 5], Math.PI / 4), 2));
  assert.ok(near(speedAt(bearings, [1, 3, 1, 5], -Math.PI / 4), 3));
  assert.equal(percentile([4, 1, 3, 2], 0.5), 2.5);
});

test("figures of rings stand where they touch neither points nor each other, and do not wander", () => {
  const points = Array.from({ length: 60 }, (_, i) => polar((i / 60) * Math.PI, 50));
  const free = freeBearing([25, 50, 75], points, null);
  assert.ok(free > Math.PI);
  const [x, y] = polar(free, 25);
  assert.ok(Math.abs(x) >= 28 || Math.abs(y) >= 14);
  assert.equal(freeBearing([25, 50, 75], points, free), free);
});

// -- the body --------------------------------------------------------------------------------

/** A box of 2 by 4 by 6 about the origin. */
function box(): Solid {
  const corners = [-1, 1].flatMap((x) => [-2, 2].flatMap((y) => [-3, 3].flatMap((z) => [x, y, z])));
  const faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
  const normals = [-127, 0, 0, 127, 0, 0, 0, -127, 0, 0, 127, 0, 0, 0, -127, 0, 0, 127];
  return new Solid({
    corners: Int16Array.from(corners), faces: Uint16Array.from(faces.flat()),
    starts: Uint16Array.from([0, 4, 8, 12, 16, 20, 24]), normals: Int8Array.from(normals),
  }, 100);
}

test("the eye's axes are square to each other, and the first look has turning up and ahead near", () => {
  const roll = dice(3);
  for (let i = 0; i < 50; i += 1) {
    const { right, up, near: out } = axesOf({ yaw: 6 * roll(), pitch: 3 * roll() - 1.5 });
    for (const [a, b] of [[right, up], [up, out], [out, right]] as const) assert.ok(Math.abs(dot(a, b)) < 1e-12);
    for (const axis of [right, up, out]) assert.ok(near(dot(axis, axis), 1));
  }
  const first = axesOf(FIRST_EYE);
  assert.ok(first.up[2] > 0 && first.near[0] > 0 && first.right[0] > 0 && first.right[1] > 0);
  assert.ok(turned(FIRST_EYE, 0, 1e4).pitch < Math.PI / 2);
});

test("a box has twelve creased edges, of two faces each, and shows three faces", () => {
  const solid = box();
  assert.equal(solid.edges.length, 12);
  assert.ok(solid.edges.every(({ faces, creased }) => faces.length === 2 && creased));
  const axes = axesOf(FIRST_EYE);
  assert.equal(solid.faces.filter((_, face) => solid.isFront(face, axes)).length, 3);
  assert.deepEqual(solid.middle, [0, 0, 0]);
  assert.ok(near(solid.radius, Math.hypot(1, 2, 3)));
  assert.equal(solid.edges.filter(({ from, to }) => isAlong(solid.corners, from, to, [0, 0, 5])).length, 4);
});

test("the rim of points holds them all and has no others", () => {
  const roll = dice(4);
  const points = Array.from({ length: 200 }, () => [roll(), roll()] as const);
  const rim = outlineOf(points);
  rim.forEach(([x, y], i) => {
    const [u, v] = rim[(i + 1) % rim.length]!;
    assert.ok(points.every(([p, q]) => (u - x) * (q - y) - (v - y) * (p - x) >= -1e-12));
    assert.ok(points.some(([p, q]) => p === x && q === y));
  });
});

// -- places and directions -------------------------------------------------------------------

function piece(more: Partial<LandscapePiece>): LandscapePiece {
  return {
    name: "port fore pads", edge: "port side", start: 80, end: 120, columns: [80, 100, 120],
    rows: [-0.5, 0, 0.5], first: 0, ...more,
  };
}

const one = (item: LandscapePiece): Column => columnsOf([item], SHAPE, 0, 100)[0]!;

test("a push and a pull that are square are both at nought", () => {
  assert.ok(near(offOf(0.2), 0.2));
  assert.ok(near(offOf(Math.PI + 0.2), 0.2) && near(offOf(-Math.PI + 0.2), 0.2));
});

test("the axis is as narrow as the rows allow, and whole where all directions are", () => {
  const degrees = (item: LandscapePiece): number => Math.round(axisOf([one(item)]).range / DEGREE);
  assert.equal(degrees(piece({ rows: [-30 * DEGREE, 30 * DEGREE] })), 35);
  assert.equal(degrees(piece({ rows: [120 * DEGREE, 240 * DEGREE] })), 65);
  assert.equal(degrees(piece({ rows: [-Math.PI, 0, Math.PI] })), 180);
  assert.deepEqual(axisOf([one(piece({}))]).ticks.map((tick) => Math.round(tick / DEGREE)), [-30, -15, 0, 15, 30]);
});

test("columns stand as their pieces do round the outline, and fill the width", () => {
  const pieces = [piece({ start: 80, end: 120 }), piece({ start: 10, end: 10 }), piece({ start: 40, end: 50 })];
  const columns = columnsOf(pieces, SHAPE, 30, 200);
  assert.deepEqual(columns.map(({ piece: { start } }) => start), [10, 40, 80]);
  assert.ok(near(columns[2]!.left + columns[2]!.width, 230));
  assert.ok(columns[2]!.width > columns[1]!.width && columns[1]!.width > columns[0]!.width);
});

test("many pieces that follow each other stand as one, and never beyond the width", () => {
  const pieces = Array.from({ length: 40 }, (_, i) => piece({ start: i < 20 ? i : i + 5, end: i < 20 ? i + 1 : i + 6 }));
  const columns = columnsOf(pieces, SHAPE, 0, 200);
  const gaps = columns.slice(1).map((column, i) => column.left - columns[i]!.left - columns[i]!.width);
  assert.equal(gaps.filter((gap) => gap > 1e-9).length, 1);
  assert.ok(near(columns[39]!.left + columns[39]!.width, 200));
});

test("values are interpolated between cells, and nothing is told where nothing is allowed", () => {
  const column = one(piece({}));
  const values = Uint16Array.from([1, 11, 21, 101, 111, 121, 201, 211, 0]);
  assert.equal(valueAt(column, values, 0, 0), 10);
  assert.ok(near(valueAt(column, values, 0.25, 0.25)!, 65));
  assert.equal(valueAt(column, values, 1, 0.5), null);
  assert.equal(valueAt(column, values, 0.5, 0.6), null);
});

test("who keeps a whole sector has a band, on the picture and on its axis", () => {
  const { problem } = doc([]);
  const alone = piece({ columns: [0, 30], rows: [0], name: "pads" });
  const band = (change: object): number => Math.round(sectorOn({ ...problem, ...change }, alone) / DEGREE);
  assert.equal(band({}), 2);
  assert.equal(band({ newcomer: { ...problem.newcomer, friction: 1 } }), 45);
  const steers = { ...problem.newcomer, steers: true, half_angle: 40 * DEGREE };
  assert.equal(band({ newcomer: steers }), 40);
  const zone = { stretch: null, attachment: null, half_angle: 10 * DEGREE, directions: null, area: null, name: "pads" };
  assert.equal(band({ newcomer: steers, zones: [zone] }), 10);
  const [column] = columnsOf([alone], SHAPE, 0, 100, () => 40 * DEGREE);
  const values = Uint16Array.from([11, 21]);
  assert.equal(valueAt(column!, values, 0, 39 * DEGREE), 10);
  assert.equal(valueAt(column!, values, 0, 41 * DEGREE), null);
  assert.equal(Math.round(axisOf([column!]).range / DEGREE), 65);
});

test("the pixels of a column are its values at their middles", () => {
  const values = Uint16Array.from([1, 11, 21, 101, 111, 121, 201, 211, 0, 7]);
  for (const column of [one(piece({})), one(piece({ columns: [10], first: 3, rows: [0.1] }))]) {
    for (const wide of [0, 1, 7]) {
      const found = pixelsOf(column, values, wide, 9, 0.6);
      assert.equal(found.length, 9 * wide);
      found.forEach((value, i) => {
        const [x, y] = [i % wide, Math.floor(i / wide)];
        const told = valueAt(column, values, wide < 2 ? 0 : x / (wide - 1), 0.6 * (1 - (2 * (y + 0.5)) / 9));
        assert.ok(Math.abs(value - (told ?? -1)) < 1e-4, `${x} ${y}: ${value} ${told}`);
      });
    }
  }
});

test("a place at a corner is on the edge that it names", () => {
  assert.equal(edgeOf(piece({ start: 60, end: 60, edge: "starboard side" }), SHAPE), 0);
  assert.equal(edgeOf(piece({ start: 60, end: 60, edge: "bow" }), SHAPE), 1);
  assert.equal(edgeOf(piece({ start: 160, end: 160, edge: "stern" }), SHAPE), 3);
});

test("names are short and never touch", () => {
  assert.equal(shortName("starboard fore bollard"), "stbd fore");
  assert.equal(shortName("pads"), "pads");
  const pieces = Array.from({ length: 12 }, (_, i) => piece({ name: `port ${"abcdefghijkl"[i]!}`, start: 10 * i, end: 10 * i }));
  const columns = columnsOf(pieces, SHAPE, 0, 240);
  const names = namesOf(columns, 7, (text) => 7 * text.length, 0, 240);
  assert.ok(names.some(({ column }) => column === 7));
  const sorted = [...names].sort((a, b) => a.x - b.x);
  sorted.slice(1).forEach((name, i) => assert.ok(name.x - sorted[i]!.x >= 7 * name.text.length + 12 - 1e-9));
});

test("colours run from low over middle to high", () => {
  const [low, middle, high] = [[0, 0, 0], [100, 0, 0], [100, 200, 0]] as const;
  assert.deepEqual([0, 0.5, 0.75, 1].map((share) => ramp(low, middle, high, share)), [[0, 0, 0], [100, 0, 0], [100, 100, 0], [100, 200, 0]]);
});

// -- slopes ----------------------------------------------------------------------------------

test("only who gains by a move has an arrow, the longest who gains most", () => {
  const rows = [
    { name: "Ajax", per_metre: 10, direction: 0, per_degree: 0, text: "" },
    { name: "Boreas", per_metre: 40, direction: Math.PI, per_degree: 0, text: "" },
    { name: "Castor", per_metre: -1, direction: 0, per_degree: 0, text: "" },
    { name: "Dione", per_metre: null, direction: null, per_degree: null, text: "" },
  ];
  const robots = rows.map(({ name }) => robot([0, -10], 1, { name }));
  const slopes: SlopesPart = { kind: "part", name: "slopes", n: 1, ms: 0, rows };
  const arrows = arrowsOf(slopes, robots, { toScreen: ([x, y]) => [100 + 3 * x, 100 - 3 * y] });
  assert.deepEqual(arrows.map(({ name }) => name), ["Ajax", "Boreas"]);
  const [ajax, boreas] = arrows.map(({ from, to }) => to[0] - from[0]);
  assert.ok(ajax! > 0 && boreas! < 0 && -boreas! > ajax!);
});
