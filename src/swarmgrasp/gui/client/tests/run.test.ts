import assert from "node:assert/strict";
import { test } from "node:test";

import { alongPath, clock, Film, leadsIn, placedAt, turnOf, type RunData } from "../src/run/film";
import { near } from "./helped";

/** Two robots, one of which is lost at 2 s, and a third that is sent then and holds from 6 s on. */
const RUN: RunData = {
  name: "run", first: { text: "Off by 3 m", good: false }, second: "", within: 2, turn: 0.1,
  outline: [[-10, -5], [10, -5], [10, 5], [-10, 5]],
  robots: [
    { name: "Ajax", contact: [0, -5], direction: Math.PI / 2, limit: 100, newcomer: false, there: [[0, 2], [2, 8]] },
    { name: "Boreas", contact: [0, 5], direction: -Math.PI / 2, limit: 50, newcomer: false, there: [[0, 2]] },
    { name: "Gaia", contact: [10, 0], direction: Math.PI, limit: 80, newcomer: true, there: [[6, 8]] },
  ],
  routes: [{ robot: "Gaia", start: 2, arrival: 4, joined: 6, points: [[30, 0], [20, 0], [10, 0]] }],
  happenings: [{ time: 2, kind: "lost", robot: "Boreas", words: "Boreas is lost" }],
  times: [0, 2, 4, 6, 8],
  poses: [0, 0, 3.1, 0, 0, 3.1, 3, 0, -3.1, 1, 0, -3.1, 0, 0, -3.1],
  references: new Array<number>(15).fill(0),
  wind: new Array<number>(10).fill(1), water: new Array<number>(10).fill(0),
  shortfalls: [0, 0, 5, 0, 0],
  forces: [50, 50, 0, 50, 0, 0, 60, 0, 0, 70, 0, 40, 80, 0, 40],
  angles: [1.5, -1.5, NaN, 1.5, NaN, NaN, 1.5, NaN, NaN, 1.5, NaN, 3, 1.5, NaN, 3],
};

test("a robot comes, makes fast and holds; one that is lost stays lost", () => {
  const film = new Film(RUN);
  const phases = (time: number): string[] => film.at(time).robots.map(({ phase }) => phase);
  assert.deepEqual(phases(0), ["holds", "holds", "away"]);
  assert.deepEqual(phases(2), ["holds", "lost", "coming"]);
  assert.deepEqual(phases(5), ["holds", "lost", "making fast"]);
  assert.deepEqual(phases(8), ["holds", "lost", "holds"]);
  assert.deepEqual(film.at(3).robots[2]!.at, [20, 0]);
  assert.equal(film.at(5).robots[2]!.done, 0.5);
  assert.equal(film.at(6).robots[2]!.share, 0.5);
});

test("between two instants the object is between their poses, the shorter way round", () => {
  const film = new Film(RUN);
  const { pose, off } = film.at(3);
  assert.ok(near(pose[0], 1.5) && near(off, 1.5));
  assert.ok(near(pose[2], 3.1 + turnOf(-6.2) / 2));
  assert.ok(Math.abs(turnOf(pose[2] - Math.PI)) < 1e-6);
  assert.equal(film.furthest, 3);
  assert.equal(film.at(100).time, 100);
  assert.deepEqual(film.at(100).pose, film.at(8).pose);
});

test("points go with the pose, along a path, and forces lead in or out", () => {
  const [x, y] = placedAt([1, 0], [10, 5, Math.PI / 2]);
  assert.ok(near(x, 10) && near(y, 6));
  assert.deepEqual(alongPath([[0, 0], [0, 0], [4, 0]], 0.25), [1, 0]);
  assert.deepEqual(alongPath([[0, 0], [4, 0], [4, 4]], 1), [4, 4]);
  assert.ok(leadsIn(RUN.outline, [0, -5], Math.PI / 2));
  assert.ok(!leadsIn(RUN.outline, [0, -5], -Math.PI / 2));
  assert.deepEqual([0, 59.99, 212].map(clock), ["0:00", "0:59", "3:32"]);
});
