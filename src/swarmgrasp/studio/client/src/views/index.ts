/* The views beside the plan. */

import type { Context, View } from "../context";
import type { Layout } from "../layout";

export function views(_layout: Layout, _context: Context): View[] {
  return [];
}
