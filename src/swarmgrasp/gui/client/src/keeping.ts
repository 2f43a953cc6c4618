/* The newcomer kept at a place: it becomes a robot there, and another one is asked about. */

import type { Context, Seen } from "./context";
import type { RobotData } from "./messages";
import { withRobots } from "./plan/adding";

/** Makes the newcomer a robot as it stands; nothing before the answer is about the document as it is. */
export function keepNewcomer(context: Context, at: RobotData): void {
  const { store } = context;
  const seen = store.seen.value;
  if (seen === null || !store.isAnswered) return;
  const name = nextName(seen, at.name);
  store.edit((doc) => {
    const kept = withRobots(doc, [at]);
    return { ...kept, problem: { ...kept.problem, newcomer: { ...kept.problem.newcomer, name } } };
  });
  store.choose(name);
  context.hover.set(null);
  context.say(`${at.name} is kept; ${name} comes next.`);
}

function nextName({ doc }: Seen, name: string): string {
  const [, root, number] = /^(.*?)(?: (\d+))?$/.exec(name || "newcomer")!;
  const taken = new Set(doc.problem.swarm.robots.map((robot) => robot.name));
  for (let i = Number(number ?? 1) + 1; ; i += 1) if (!taken.has(`${root} ${i}`)) return `${root} ${i}`;
}
