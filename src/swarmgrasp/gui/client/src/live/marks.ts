/* Marks of live robots in the plan: who comes, who is confirmed, who is not heard, who hears whom. */

import { Pool, put, svg, write } from "../dom";
import type { Pair } from "../messages";
import type { PlanLayer } from "../plan/plan";
import { sideOf, type Agent } from "./agents";

const [RING, REACH] = [12, 56];
const ROUND = 2 * Math.PI * RING;

interface Mark {
  readonly agent: Agent;
  readonly at: Pair;
  /** Where it comes from, on the card. */
  readonly from: Pair;
  readonly side: number | null;
}

export class Marks {
  readonly group = svg("g", { class: "agents" });
  readonly #pool: Pool<SVGGElement, Mark>;

  constructor(readonly layer: PlanLayer) {
    this.#pool = new Pool(this.group, makeMark, dressMark);
    layer.group.ownerSVGElement!.append(this.group);
  }

  draw(agents: Iterable<Agent>, sides: readonly (readonly string[])[]): void {
    const marks: Mark[] = [];
    for (const agent of agents) {
      const { at: contact, direction } = agent;
      if (agent.phase === "idle" || agent.phase === "left" || contact === null || direction === null) continue;
      const at = this.layer.toScreen(contact);
      const [x, y] = this.layer.toScreen([contact[0] - Math.cos(direction), contact[1] - Math.sin(direction)]);
      const size = Math.hypot(x - at[0], y - at[1]) || 1;
      const from: Pair = [at[0] + (REACH * (x - at[0])) / size, at[1] + (REACH * (y - at[1])) / size];
      marks.push({ agent, at, from, side: sideOf(agent.name, sides) });
    }
    this.#pool.draw(marks);
  }

  clear(): void {
    this.#pool.draw([]);
  }
}

function makeMark(): SVGGElement {
  return svg("g", { class: "agent" },
    svg("title"), svg("line", { class: "agent-way" }), svg("circle", { class: "agent-side", r: RING + 5 }),
    svg("circle", { class: "agent-ring", r: RING }), svg("text", { class: "agent-name" }));
}

function dressMark(node: SVGGElement, { agent, at, from, side }: Mark): void {
  const [title, way, around, ring, name] = node.children;
  put(node, { "data-phase": agent.phase, "data-there": agent.there });
  write(title!, `${agent.name}: ${agent.phase}`);
  put(way!, { x1: from[0], y1: from[1], x2: at[0], y2: at[1], hidden: agent.there });
  put(around!, { cx: at[0], cy: at[1], "data-side": side === null ? null : side % 3, hidden: side === null });
  const share = agent.phase === "arrived" && agent.of > 0 ? agent.confirmed / agent.of : 1;
  put(ring!, {
    cx: at[0], cy: at[1], hidden: agent.phase === "holds",
    "stroke-dasharray": agent.phase === "arrived" ? `${(ROUND * share).toFixed(1)} ${ROUND.toFixed(1)}` : null,
    transform: `rotate(-90 ${at[0]} ${at[1]})`,
  });
  put(name!, { x: from[0] + (from[0] - at[0]) * 0.3, y: from[1] + 4 + (from[1] - at[1]) * 0.3, hidden: agent.there });
  write(name!, agent.there ? "" : `${agent.name} ${agent.phase === "arrived" ? `${agent.confirmed} of ${agent.of}` : agent.phase}`);
}
