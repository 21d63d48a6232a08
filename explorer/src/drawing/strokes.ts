/** How the line of each motion looks: its colour has one meaning everywhere, its dash says it a second time. */

import type { InkName } from "./ink";

export type Drawn = "exact" | "cubic" | "ellipse" | "linear";

export interface Stroke {
  readonly ink: InkName;
  /** px on and off; empty for a solid line. Dots have a length near 0 and round ends. */
  readonly dash: readonly number[];
  readonly width: number;
}

export const STROKES: Record<Drawn, Stroke> = {
  exact: { ink: "exact", dash: [], width: 1.5 },
  cubic: { ink: "cubic", dash: [13, 5], width: 2.2 },
  ellipse: { ink: "ellipse", dash: [9, 4, 2, 4], width: 2.2 },
  linear: { ink: "linear", dash: [0.1, 5.5], width: 2.4 },
};

/** What the Earth alone would do; never together with the linear rung, whose colour it shares. */
export const EARTH: Stroke = { ink: "linear", dash: [8, 5], width: 2 };
