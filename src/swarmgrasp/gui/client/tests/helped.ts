/* What several tests begin with. */

import type { Doc, OutlineData, Pair, RobotData } from "../src/messages";

/** A barge of 60 m by 20 m, its corners counter-clockwise from aft to starboard. */
export const BARGE: OutlineData = {
  vertices: [[-30, -10], [30, -10], [30, 10], [-30, 10]], origin: [0, 0],
  edge_names: ["starboard side", "bow", "port side", "stern"], precision: 0,
};

export function robot(contact: Pair, direction: number, more: Partial<RobotData> = {}): RobotData {
  return {
    contact, direction, limit: 100, name: "Ajax", mounted: false, tolerance: null, reverse_limit: 0, steers: 0,
    friction: null, least: 0, envelope: null, group: "", sectors: null, body: null, lever: 0, ...more,
  };
}

export function doc(robots: RobotData[]): Doc {
  return {
    name: "Barge", description: "", environment: null, in_weather: false, newcomer: true,
    problem: {
      swarm: { outline: BARGE, robots, characteristic_length: Math.hypot(30, 10), force_weights: [1, 1] },
      newcomer: {
        limit: 50, attachment: "push", half_angle: 0.5, name: "Dione", tolerance: null, steers: false,
        reverse_limit: 0, friction: null, mounted: false, body: null,
      },
      zones: null, no_go: [], spacing: 0,
      criterion: { losing: 0, worst_case: false, load: [0, 0, 0], task: null, failures: [] },
    },
  };
}

/** Numbers within [0, 1), the same each time. */
export function dice(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

export function near(actual: number, expected: number): boolean {
  return Math.abs(actual - expected) < 1e-9 * Math.max(1, Math.abs(expected));
}
