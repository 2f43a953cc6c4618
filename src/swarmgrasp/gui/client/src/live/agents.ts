/* Robots that decide for themselves, as they are told: who is there, who comes, who is not heard. No DOM. */

import type { Live, LiveRobot } from "../messages";

/** A robot, as the server tells of it. */
export type Agent = LiveRobot;
export type LiveData = Omit<Live, "kind">;
export type Order = "kill" | "stop" | "go on" | "come" | "leave";

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
  if (phase === "left") return "has left";
  if (hears === null) return "heard here";
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

/** What can be done to one in a demonstration: only what changes something. */
export function ordersFor({ process, phase }: Agent): Order[] {
  if (process === null) return [];
  if (process === "ended") return ["go on"];
  if (process === "stopped") return ["go on", "kill"];
  const first: Order[] = phase === "idle" || phase === "left" ? ["come"] : phase === "holds" ? ["leave"] : [];
  return [...first, "stop", "kill"];
}

/** Words of an order's button. */
export function orderWord(order: Order, { process, phase }: Agent): string {
  if (order === "go on" && process === "ended") return "start again";
  return order === "come" && phase === "left" ? "join again" : order;
}

/** How many hold and how many come. */
export function countWords(agents: Iterable<Agent>): string {
  let [hold, come] = [0, 0];
  for (const { there, phase } of agents) {
    if (there) hold += 1;
    else if (phase === "coming" || phase === "arrived" || phase === "making fast") come += 1;
  }
  return `${hold} ${hold === 1 ? "holds" : "hold"}${come > 0 ? `, ${come} to come` : ""}`;
}
