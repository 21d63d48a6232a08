/** The drawing of each example, from the core itself. */

import type { Core, Given } from "../core";
import { HOUR } from "../numbers/ladders";
import { modeOf } from "../state/live";
import { PRESETS } from "../state/presets";
import type { PresetKey } from "../words/presets";

export interface Thumb {
  /** Path in a box from −50 to 50. */
  readonly path: string;
  /** Opacity of each of its pieces where there are several lines. */
  readonly lines: readonly { readonly d: string; readonly opacity: number; readonly width: number }[];
  readonly ring: boolean;
}

/** Radius of the drawing, and how long each motion is drawn, s. */
const SIZE = 42;
const SPANS: Partial<Record<PresetKey, number>> = { rosette: 36.4, small: 2.01, straight: 16.5, cone: 3.5, over: 5, separatrix: 50 };

export function thumbOf(core: Core, key: PresetKey): Thumb {
  const { given } = PRESETS[key];
  const mode = modeOf(given);
  if (mode === "free") return freeThumb(core, given, SPANS[key] ?? 10, key);
  if (mode === "pair") return { path: "", lines: pairLines(), ring: true };
  return { path: "", lines: hours(core, given, PRESETS[key].duration), ring: true };
}

function freeThumb(core: Core, given: Given, span: number, key: PresetKey): Thumb {
  const motion = core.motion(given, "exact");
  const count = key === "rosette" || key === "separatrix" ? 1100 : 180;
  const points = motion.positions(Float64Array.from({ length: count }, (_, index) => (span * index) / (count - 1)));
  motion.free();
  let most = 0;
  for (let index = 0; index < count; index++) most = Math.max(most, Math.hypot(points[3 * index] ?? 0, points[3 * index + 1] ?? 0));
  let path = "";
  for (let index = 0; index < count; index++) {
    const [x, y] = [(SIZE * (points[3 * index] ?? 0)) / most, (-SIZE * (points[3 * index + 1] ?? 0)) / most];
    path += `${index ? "L" : "M"}${x.toFixed(1)} ${y.toFixed(1)}`;
  }
  return { path, lines: [], ring: key === "small" };
}

/** The direction of the plane at each of some hours, the last one strong. */
function hours(core: Core, given: Given, duration: number): Thumb["lines"] {
  const motion = core.motion(given, "averaged");
  const shown = Math.min(duration, 12 * HOUR);
  const times = Float64Array.from({ length: 13 }, (_, index) => (shown * index) / 12);
  // What takes longer than a moment is left to the page itself.
  motion.reach(shown);
  const azimuths = motion.azimuths(times);
  motion.free();
  const found: { d: string; opacity: number; width: number }[] = [];
  azimuths.forEach((azimuth, index) => {
    if (Number.isNaN(azimuth)) return;
    const [x, y] = [SIZE * 0.92 * Math.cos(azimuth), -SIZE * 0.92 * Math.sin(azimuth)];
    const last = index === azimuths.length - 1;
    found.push({ d: `M${x.toFixed(1)} ${y.toFixed(1)}L${(-x).toFixed(1)} ${(-y).toFixed(1)}`, opacity: last ? 1 : 0.55, width: last ? 4 : 1.3 });
  });
  return found;
}

/** Two circles that are run through in opposite senses. */
function pairLines(): Thumb["lines"] {
  const arc = (radius: number, from: number, to: number): string => {
    const at = (angle: number): string => `${(radius * Math.cos(angle)).toFixed(1)} ${(-radius * Math.sin(angle)).toFixed(1)}`;
    return `M${at(from)}A${radius} ${radius} 0 1 ${to > from ? 0 : 1} ${at(to)}`;
  };
  return [
    { d: arc(31, -0.4, 4.6), opacity: 1, width: 2.6 },
    { d: arc(22, 0.5, -4.6), opacity: 1, width: 2.6 },
  ];
}
