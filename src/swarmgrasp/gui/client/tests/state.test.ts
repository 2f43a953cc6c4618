import assert from "node:assert/strict";
import { test } from "node:test";

import { decoded, encoded } from "../src/frames";
import { History } from "../src/history";
import type { Incoming, Outgoing, Scene, SpeechData } from "../src/messages";
import { fromLink, toLink } from "../src/share";
import { Signal } from "../src/signal";
import { figure, SILENT, Speech } from "../src/speech";
import { Store } from "../src/state";
import { Talk } from "../src/talk";
import type { Wire } from "../src/wire";
import { doc, robot } from "./helped";

test("a gesture is one step, and one that changes nothing is none", () => {
  const history = new History(0);
  for (const value of [1, 2, 3]) history.move(value);
  history.settle();
  history.set(9);
  history.move(10);
  history.move(9);
  history.settle();
  assert.deepEqual([history.undo(), history.now, history.undo(), history.now, history.undo()], [true, 3, true, 0, false]);
  assert.deepEqual([history.redo(), history.now, history.redo(), history.now, history.redo()], [true, 3, true, 9, false]);
});

test("a gesture that is left has not been", () => {
  const history = new History("a");
  history.move("b");
  history.abandon();
  assert.deepEqual([history.now, history.canUndo], ["a", false]);
});

test("a change after an undo ends what could be redone", () => {
  const history = new History(1);
  history.set(2);
  history.undo();
  history.set(3);
  assert.equal(history.canRedo, false);
});

test("a link gives the text back", async () => {
  const text = "name: Größe ↑\nrobots: []\n".repeat(200);
  const link = await toLink(text);
  assert.ok(/^[\w-]+$/.test(link) && link.length < text.length / 10);
  assert.equal(await fromLink(link), text);
});

test("a link that inflates beyond its limit is refused, and so is a broken one", async () => {
  await assert.rejects(fromLink(await toLink("a".repeat(3 << 20))), /1 MB/);
  await assert.rejects(fromLink("AAAA"), /./);
});

test("figures have one decimal below ten, groups from ten thousand on, and a true minus", () => {
  const told = [0, 4.51, 9.94, 9.96, 34.4, 89868, -0.26, -20.96].map((value) => figure(value));
  assert.deepEqual(told, ["0", "4.5", "9.9", "10", "34", "89\u00a0868", "−0.26", "−21"]);
});

test("points and bearings are told in the file's frame and back", () => {
  const marine: SpeechData = { ...SILENT, mirrored: true, bow: Math.PI / 2, heading: Math.PI / 6, length: { unit: "ft", size: 0.3048, label: "ft" } };
  const speech = new Speech(marine);
  const [x, y] = speech.fromFile(speech.toFile([3, -4]));
  assert.ok(Math.hypot(x - 3, y + 4) < 1e-12);
  assert.equal(speech.bearingOf(Math.PI / 2), "300°");
  assert.equal(new Speech(SILENT).force(229220), "229\u00a0kN");
});

test("many robots travel as columns, and arrays come back under their names", () => {
  const many = Array.from({ length: 501 }, (_, i) => robot([i, -i], i / 7, { name: `R${i + 1}`, limit: 2 * i }));
  const message: Outgoing = { kind: "ask", n: 3, moving: true, doc: doc(many), speech: SILENT };
  const frame = encoded(message) as ArrayBuffer;
  const length = new DataView(frame).getUint32(0, true);
  assert.equal((4 + length) % 8, 0);
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(frame, 4, length)));
  assert.deepEqual([head.doc.problem.swarm.robots, head.names], [[], undefined]);
  const columns = new Float64Array(frame, 4 + length);
  assert.deepEqual([columns[2 * 500], columns[2 * 501 + 7], columns[3 * 501 + 500]], [500, 1, 1000]);
  assert.equal(typeof encoded({ ...message, doc: doc(many.slice(0, 500)) }), "string");
  const steering = many.map((one, i) => (i === 7 ? { ...one, steers: 0.5 } : one));
  assert.equal(typeof encoded({ ...message, doc: doc(steering) }), "string");
});

test("a frame's arrays begin at multiples of eight", () => {
  const words = JSON.stringify({ kind: "part", arrays: [{ name: "a", type: "i1", shape: [3] }, { name: "b", type: "f4", shape: [1, 2] }] });
  const head = words + " ".repeat((12 - (words.length % 8)) % 8);
  const frame = new ArrayBuffer(4 + head.length + 16);
  new DataView(frame).setUint32(0, head.length, true);
  new Uint8Array(frame).set(new TextEncoder().encode(head), 4);
  new Int8Array(frame, 4 + head.length).set([1, -2, 3]);
  new Float32Array(frame, 4 + head.length + 8).set([0.5, -1]);
  const message = decoded(frame) as unknown as { a: Int8Array; b: Float32Array };
  assert.deepEqual([[...message.a], [...message.b]], [[1, -2, 3], [0.5, -1]]);
});

// -- talking -------------------------------------------------------------------------------

class Line implements Wire {
  readonly up = new Signal(false);
  readonly refusal = new Signal<string | null>(null);
  readonly sent: { kind: string; n: number; doc: { name: string } }[] = [];
  hear: (data: string | ArrayBuffer) => void = () => undefined;
  retry(): void {}
  close(): void {}

  send(data: string | ArrayBuffer): void {
    this.sent.push(JSON.parse(data as string));
  }

  say(message: object): void {
    this.hear(JSON.stringify(message));
  }

  welcome(message = 1e6): void {
    this.up.set(true);
    this.say({ kind: "welcome", limits: { message }, scenes: [] });
  }

  /** What was sent since the last look. */
  take(): [string, string | undefined][] {
    return this.sent.splice(0).map(({ kind, doc: sent }) => [kind, sent?.name]);
  }
}

const named = (name: string): ReturnType<typeof doc> => ({ ...doc([]), name });

test("one ask is in flight and the newest waits; the next goes on the answer", () => {
  const line = new Line();
  const talk = new Talk(line, () => "key");
  line.welcome();
  for (const name of ["a", "b", "c"]) talk.ask(named(name), SILENT, true);
  assert.deepEqual(line.take(), [["hello", undefined], ["ask", "a"]]);
  line.say({ kind: "part", name: "mesh", n: 1 });
  assert.deepEqual(line.take(), []);
  line.say({ kind: "part", name: "answer", n: 1 });
  assert.deepEqual(line.take(), [["ask", "c"]]);
});

test("what was asked when the line fell is asked again", async () => {
  const line = new Line();
  const talk = new Talk(line, () => "key");
  line.welcome();
  talk.ask(named("a"), SILENT, false);
  const reply = talk.request({ kind: "open", name: "x" });
  await Promise.resolve();
  line.up.set(false);
  talk.ask(named("b"), SILENT, false);
  line.take();
  line.welcome();
  const again = line.sent.map(({ kind, n }) => [kind, n]);
  assert.deepEqual(again, [["hello", undefined], ["open", 2], ["ask", 1]]);
  line.say({ kind: "refused", n: 1, faults: [] });
  assert.deepEqual(line.take().at(-1), ["ask", "b"]);
  line.say({ kind: "error", n: 2, say: "no" });
  assert.equal((await reply as { say: string }).say, "no");
});

test("what is too large to send is said, not sent", async () => {
  const line = new Line();
  const talk = new Talk(line, () => "key");
  line.welcome(100);
  const heard: Incoming[] = [];
  talk.hear = (message) => heard.push(message);
  line.take();
  talk.ask(named("a"), SILENT, false);
  await Promise.resolve();
  assert.deepEqual([line.take(), heard.map(({ kind }) => kind)], [[], ["error"]]);
});

test("parts of another scene are not drawn, and a refusal keeps the last answer", () => {
  const store = new Store();
  let n = 0;
  store.ask = () => (n += 1);
  const scene: Scene = { kind: "scene", n: 0, name: "a", text: "", doc: named("a"), speech: SILENT, warnings: [] };
  store.open(scene);
  store.open({ ...scene, doc: named("b") });
  const answer = (of: number): Incoming => ({ kind: "part", name: "answer", n: of } as Incoming);
  store.take(answer(1));
  assert.equal(store.seen.value!.parts.answer, undefined);
  store.take(answer(2));
  store.take({ kind: "refused", n: 3, faults: [{ line: null, column: null, path: "", sentence: "too near" }] });
  assert.equal(store.seen.value!.refused[0]!.sentence, "too near");
  assert.ok(store.seen.value!.parts.answer !== undefined);
  store.take(answer(4));
  assert.deepEqual(store.seen.value!.refused, []);
});
