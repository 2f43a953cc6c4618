/* Binary frames: u32 length | JSON head padded with spaces to a multiple of 8 | arrays. */

import type { Doc, Incoming, Outgoing, RobotData } from "./messages";

const ARRAYS = {
  f4: Float32Array, f8: Float64Array, i1: Int8Array, i2: Int16Array, u2: Uint16Array, u4: Uint32Array,
} as const;

interface ArrayHead {
  name: string;
  type: keyof typeof ARRAYS;
  shape: number[];
}

/** From so many robots on, a document travels as columns. */
export const COLUMNS_FROM = 500;

/** What a frame says: its head, with the arrays of its body under their names. */
export function decoded(data: string | ArrayBuffer): Incoming {
  if (typeof data === "string") return JSON.parse(data) as Incoming;
  const length = new DataView(data).getUint32(0, true);
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(data, 4, length))) as
    Record<string, unknown> & { arrays?: ArrayHead[] };
  let at = 4 + length;
  for (const { name, type, shape } of head.arrays ?? []) {
    const kind = ARRAYS[type];
    const count = shape.reduce((product, side) => product * side, 1);
    at = Math.ceil(at / 8) * 8;
    head[name] = new kind(data, at, count);
    at += count * kind.BYTES_PER_ELEMENT;
  }
  return head as unknown as Incoming;
}

/** Whether contact, direction and limit are all that there is of a robot. */
function isLine(robot: RobotData): boolean {
  return !robot.mounted && robot.tolerance === null && robot.reverse_limit === 0 && robot.steers === 0
    && robot.friction === null && robot.least === 0 && robot.envelope === null && robot.group === ""
    && robot.sectors === null && robot.body === null && robot.lever === 0;
}

/** What is sent: text, or columns where a document holds many robots that push along a line each. */
export function encoded(message: Outgoing): string | ArrayBuffer {
  if (!("doc" in message)) return JSON.stringify(message);
  const { robots } = message.doc.problem.swarm;
  if (robots.length <= COLUMNS_FROM || !robots.every(isLine)) return JSON.stringify(message);
  const plain = robots.every((robot, i) => robot.name === `R${i + 1}`);
  const head = {
    ...message,
    doc: withRobots(message.doc, []),
    ...(plain ? {} : { names: robots.map((robot) => robot.name) }),
  };
  const words = new TextEncoder().encode(JSON.stringify(head));
  const length = Math.ceil((words.length + 4) / 8) * 8 - 4;
  const frame = new ArrayBuffer(4 + length + 32 * robots.length);
  new DataView(frame).setUint32(0, length, true);
  const bytes = new Uint8Array(frame);
  bytes.fill(0x20, 4, 4 + length);
  bytes.set(words, 4);
  const columns = new Float64Array(frame, 4 + length);
  robots.forEach((robot, i) => {
    columns[2 * i] = robot.contact[0];
    columns[2 * i + 1] = robot.contact[1];
    columns[2 * robots.length + i] = robot.direction;
    columns[3 * robots.length + i] = robot.limit;
  });
  return frame;
}

function withRobots(doc: Doc, robots: []): Doc {
  return { ...doc, problem: { ...doc.problem, swarm: { ...doc.problem.swarm, robots } } };
}
