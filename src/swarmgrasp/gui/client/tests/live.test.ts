import assert from "node:assert/strict";
import { test } from "node:test";

import { countWords, cutWords, orderWord, ordersFor, sideOf, taken, wordsOf, type Agent, type LiveData } from "../src/live/agents";

function agent(name: string, more: Partial<Agent> = {}): Agent {
  return {
    name, phase: "holds", at: [0, 0], direction: 0, limit: 1, confirmed: 0, of: 0, hears: 2, deaf: [], there: true,
    process: "runs", ...more,
  };
}

function told(robots: Agent[], whole: boolean): LiveData {
  return { t: 0, whole, first: { text: "", good: true }, second: "", certified: null, robots, sides: [], conflicts: [], cut: false };
}

test("what changed takes the place of what was told before, in the order of names", () => {
  const first = taken(new Map(), told([agent("Tug 10"), agent("Tug 9")], true));
  assert.deepEqual([...first.keys()], ["Tug 9", "Tug 10"]);
  const second = taken(first, told([agent("Tug 9", { phase: "not answering" })], false));
  assert.equal(second.get("Tug 9")!.phase, "not answering");
  assert.equal(second.size, 2);
  assert.equal(taken(second, told([agent("Ajax")], true)).size, 1);
});

test("who is not heard is named, and never told as fine", () => {
  assert.equal(wordsOf(agent("Ajax")), "hears all 2");
  assert.equal(wordsOf(agent("Ajax", { deaf: ["Boreas", "Castor"] })), "hears 2, not Boreas, Castor");
  assert.equal(wordsOf(agent("Ajax", { deaf: ["B", "C", "D", "E"] })), "hears 2, not 4 others");
  assert.ok(/not heard/.test(wordsOf(agent("Ajax", { phase: "not answering" }))));
  assert.equal(wordsOf(agent("Ajax", { phase: "arrived", confirmed: 3, of: 5, there: false })), "confirmed by 3 of 5 heard");
});

test("where it is not known who hears whom, that is not told", () => {
  assert.equal(wordsOf(agent("Ajax", { hears: null, process: null })), "heard here");
  assert.deepEqual(ordersFor(agent("Ajax", { process: null })), []);
});

test("only what changes something can be ordered", () => {
  const orders = (more: Partial<Agent>): string[] => ordersFor(agent("Ajax", more)).map((order) => orderWord(order, agent("Ajax", more)));
  assert.deepEqual(orders({}), ["leave", "stop", "kill"]);
  assert.deepEqual(orders({ phase: "idle", there: false }), ["come", "stop", "kill"]);
  assert.deepEqual(orders({ phase: "left", there: false }), ["join again", "stop", "kill"]);
  assert.deepEqual(orders({ phase: "not answering", process: "stopped" }), ["go on", "kill"]);
  assert.deepEqual(orders({ phase: "not answering", process: "ended" }), ["start again"]);
});

test("sides are told only where there are several", () => {
  assert.equal(sideOf("Ajax", [["Ajax", "Boreas"]]), null);
  assert.equal(sideOf("Castor", [["Ajax"], ["Castor"]]), 1);
  assert.equal(cutWords([["Ajax", "Boreas"]]), "");
  assert.ok(/Out of touch: Ajax \| Castor, Dione\./.test(cutWords([["Ajax"], ["Castor", "Dione"]])));
  assert.equal(countWords([agent("A"), agent("B", { there: false, phase: "coming" }), agent("C", { there: false, phase: "idle" })]), "1 holds, 1 to come");
});
