/* The views beside the plan. */

import type { Context, View } from "../context";
import type { Layout } from "../layout";
import type { PlanLayer } from "../plan/plan";

export function views(_layout: Layout, _context: Context, _layer: PlanLayer): View[] {
  return [];
}
