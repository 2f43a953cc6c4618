/* Robots that decide for themselves, as they are told: who is there, who comes, who is not heard. No DOM. */

import type { Live, LiveRobot } from "../messages";

/** A robot, as the server tells of it. */
export type Agent = LiveRobot;
export type LiveData = Omit<Live, "kind">;

/** All robots after a message, by name. */
export function taken(before: ReadonlyMap<string, Agent>, data: LiveData): ReadonlyMap<string, Agent> {
  const agents = new Map(data.whole ? [] : before);
  for (const agent of data.robots) agents.set(agent.name, agent);
  return new Map([...agents].sort(([a], [b]) => a.localeCompare(b, undefined, { numeric: true })));
}

/** Which side each is on; null while all are in touch. */
export function sideOf(name: string, sides: readonly (readonly string[])[]): number | null {
  if (sides.length < 2) return null;
  const side = sides.findIndex((names) => names.includes(name));
  return side < 0 ? null : side;
}

const MOST_NAMED = 2;

/** What is told of one beside its phase. */
export function wordsOf({ phase, confirmed, of, hears, deaf }: Agent): string {
  if (phase === "arrived" || phase === "making fast" || phase === "coming") {
    return of > 0 ? `confirmed by ${confirmed} of ${of} heard` : "asks to confirm";
  }
  if (phase === "not answering") return "not heard; counted as holding until it is missed";
  if (deaf.length === 0) return `hears all ${hears}`;
  const names = deaf.length > MOST_NAMED + 1 ? `${deaf.length} others` : deaf.join(", ");
  return `hears ${hears}, not ${names}`;
}

/** The sentence of those that are out of touch, or an empty one. */
export function cutWords(sides: readonly (readonly string[])[]): string {
  if (sides.length < 2) return "";
  const said = sides.map((names) => names.join(", ")).join(" | ");
  return `Out of touch: ${said}. Each side goes on; what is certified holds whatever the other does.`;
}

/** How many hold and how many come. */
export function countWords(agents: Iterable<Agent>): string {
  let [hold, come] = [0, 0];
  for (const { there, phase } of agents) {
    if (there) hold += 1;
    else if (phase !== "idle" && phase !== "leaving") come += 1;
  }
  return `${hold} ${hold === 1 ? "holds" : "hold"}${come > 0 ? `, ${come} to come` : ""}`;
}
