/** Where a swing would be a flicker: the ellipse on which the bob swings, with a bob at each end. */

import { camera } from "./sight";
import { BOB_RADIUS, type Scene } from "../drawing/scene";
import { faded } from "../drawing/ink";
import { EARTH } from "../drawing/strokes";
import { HOUR } from "../numbers/ladders";
import type { EllipseNow } from "../core";
import type { Live } from "../state/live";
import { duration } from "../state/page";
import { drawBearing, drawSector } from "./over";
import { ellipseStrand, enlargement, type Enlarged } from "./strands";

/** Earlier ellipses, one an hour. */
interface History {
  readonly live: Live;
  readonly ellipses: EllipseNow[];
}

let history: History | null = null;

/** The ellipses of each hour up to a time, kept from frame to frame. */
export function earlier(live: Live, time: number): History {
  if (history?.live !== live) history = { live, ellipses: [] };
  const every = HOUR;
  for (let index = history.ellipses.length; index * every <= time; index++) {
    const found = live.ellipse(index * every);
    if (!found) break;
    history.ellipses.push(found);
  }
  return history;
}

/** By how much length and width are enlarged: the same from start to end of what the timeline shows. */
export function enlarged(live: Live): Enlarged {
  return enlargement(live.hand.pull, live.widest(duration.value), live.given.pendulum.length);
}

type Base = Pick<Scene, "camera" | "ink" | "floorRadius" | "rod">;

export function averagedScene(base: Base, live: Live, time: number, context: CanvasRenderingContext2D): Scene {
  const { ink } = base;
  const ellipse = live.ellipse(time);
  if (!ellipse) return { ...base, strands: [], bobs: [], threads: [] };
  const { length } = live.given.pendulum;
  const by = enlarged(live);
  const past = earlier(live, time).ellipses.slice(-24);
  const strands = past.slice(-6).map((one, index, all) =>
    ellipseStrand(`hour ${index}`, one, length, by, {
      color: ink.color.exact,
      width: 1.2 * ink.weight,
      alpha: [0.16 + (0.3 * index) / all.length, 0.16 + (0.3 * index) / all.length],
      onFloor: true,
    }),
  );
  strands.push(ellipseStrand("ellipse", ellipse, length, by, { color: ink.color.exact, width: 3.4 * ink.weight, alpha: [1, 1], onFloor: false }));
  drawSector(context, camera, ink, base.floorRadius, live.hand.azimuth, ellipse.azimuth - live.hand.azimuth);
  drawBearing(context, camera, 0.72 * base.floorRadius, live.hand.azimuth, faded(ink.color.soft, 0.9), 1.2, [2, 4]);
  drawBearing(context, camera, 0.8 * base.floorRadius, live.hand.azimuth + live.settled.earth * time, ink.color[EARTH.ink], EARTH.width, EARTH.dash);
  drawBearing(context, camera, 0.96 * base.floorRadius, ellipse.azimuth, ink.color.exact, 1.8, []);
  const far = (by.long * ellipse.a) / length;
  const [x, y, z] = [far * Math.cos(ellipse.azimuth), far * Math.sin(ellipse.azimuth), -Math.sqrt(Math.max(0, 1 - far * far))];
  const ends = ([[x, y, z], [-x, -y, z]] as const).map((at) => ({ at, radius: BOB_RADIUS, ring: null, alpha: 0.78 }));
  drawFan(context, ends.map((one) => one.at), ink.color.exact);
  return { ...base, strands, bobs: ends, threads: ends.map((one) => one.at) };
}

/** The fan that the wire sweeps. */
function drawFan(context: CanvasRenderingContext2D, ends: readonly (readonly [number, number, number])[], color: string): void {
  const [first] = ends;
  if (!first) return;
  const support = camera.project([0, 0, 0]);
  const lowest = camera.project([0, 0, -1]);
  const shade = context.createLinearGradient(0, support.y, 0, lowest.y);
  shade.addColorStop(0, faded(color, 0.05));
  shade.addColorStop(1, faded(color, 0.2));
  context.fillStyle = shade;
  context.beginPath();
  context.moveTo(support.x, support.y);
  // Along the sphere from one turning point to the other.
  for (let step = 0; step <= 32; step++) {
    const share = 1 - step / 16;
    const [x, y] = [first[0] * share, first[1] * share];
    const at = camera.project([x, y, -Math.sqrt(Math.max(0, 1 - x * x - y * y))]);
    context.lineTo(at.x, at.y);
  }
  context.fill();
}
