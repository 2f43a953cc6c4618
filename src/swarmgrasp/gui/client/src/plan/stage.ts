/* What a drawing of the plan works from, made once a frame. */

import type { Hovered, Seen } from "../context";
import type { Pair, RobotData } from "../messages";
import type { Speech } from "../speech";
import { FEW_NAMES, figureOf, scaleOf, CANVAS_FROM, type Figure, type Scale } from "./figures";
import type { Screen } from "./screen";
import type { Shape } from "./shape";

export interface Stage {
  readonly seen: Seen;
  readonly shape: Shape;
  readonly screen: Screen;
  readonly scale: Scale;
  readonly speech: Speech;
  readonly hovered: Hovered | null;
  /** Robots that are drawn one by one; of a crowd none. */
  readonly figures: readonly Figure[];
  /** The newcomer at its best place. */
  readonly newcomer: Figure | null;
  /** Names of those that are lost in the worst case. */
  readonly lost: ReadonlySet<string>;
  readonly centre: Pair;
  readonly crowded: boolean;
  /** Whether a name is worth its room. */
  readonly matters: (name: string) => boolean;
}

/** @param instead the newcomer where it goes with others, in the place of where it goes alone. */
export function stageOf(seen: Seen, shape: Shape, screen: Screen, speech: Speech, hovered: Hovered | null, instead: RobotData | null): Stage {
  const { robots } = seen.doc.problem.swarm;
  const answer = seen.parts.answer;
  const placed = seen.doc.newcomer && answer?.newcomer != null ? instead ?? answer.newcomer : null;
  // It is known by the document's name, also where it has none.
  const best = placed === null ? null : { ...placed, name: seen.doc.problem.newcomer.name };
  const scale = scaleOf(robots.length > 1000 ? robots : best === null ? robots : [...robots, best], screen);
  const crowded = robots.length > CANVAS_FROM;
  const lost = new Set(answer?.worst_loss ?? []);
  const setBy = new Set(answer?.weakest?.names ?? []);
  const few = robots.length > FEW_NAMES;
  const named = (name: string): boolean =>
    name === seen.chosen || lost.has(name) || (setBy.has(name) && setBy.size <= 4);
  const drawn = crowded ? robots.filter((robot) => robot.name === seen.chosen) : robots;
  return {
    seen, shape, screen, scale, speech, hovered, lost, crowded,
    figures: drawn.map((robot) => figureOf(robot, false, shape, screen, scale)),
    newcomer: best === null ? null : figureOf(best, true, shape, screen, scale),
    centre: screen.at(shape.origin),
    matters: (name) => !few || named(name),
  };
}
