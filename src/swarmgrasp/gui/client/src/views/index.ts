/* The views beside the plan. */

import type { Context, View } from "../context";
import type { Layout } from "../layout";
import { Live } from "../live/live";
import type { PlanLayer } from "../plan/plan";
import type { Later } from "../sequence";
import { Player } from "../run/player";
import { Answer } from "./answer";
import { Body } from "./body";
import { makeDrawer } from "./drawer";
import { Landscape } from "./landscape";
import { Losses } from "./losses";
import { Rose } from "./rose";
import { Slopes } from "./slopes";

export function views(layout: Layout, context: Context, layer: PlanLayer, later: Later): View[] {
  makeDrawer(layout, context);
  return [
    new Answer(layout.answer, context, later),
    new Losses(layout.losses, context),
    new Body(layout.wrench, context),
    new Rose(layout.rose, context),
    new Landscape(layout.land, context),
    new Slopes(layer, context),
    new Player(layout, context),
    new Live(layout, context, layer),
  ];
}
