/** What lies over the pendulum while a hand holds it: ring, arrow, arc, and the first swing before it is let go. */

import type { Camera, Point } from "../drawing/camera";
import { FLOOR } from "../drawing/camera";
import { trace } from "../drawing/floor";
import { faded, type Ink } from "../drawing/ink";
import { BOB_RADIUS, placed } from "../drawing/scene";
import type { Live } from "../state/live";
import { kiosk } from "../state/page";
import { arrow } from "./grip";

const POINTS = 120;

export function drawOver(context: CanvasRenderingContext2D, camera: Camera, ink: Ink, live: Live): void {
  const { length } = live.given.pendulum;
  context.strokeStyle = ink.color.ink;
  context.lineWidth = 1.5;
  const rest = camera.project([0, 0, -1]);
  context.setLineDash([2, 4]);
  context.beginPath();
  context.arc(rest.x, rest.y, BOB_RADIUS * rest.scale, 0, 2 * Math.PI);
  context.stroke();
  trace(context, arc(live).map((one) => camera.project(one)));
  context.stroke();
  drawFirstSwing(context, camera, ink, live, length);
  context.setLineDash([]);
  const at = place(live);
  const { x, y, scale } = camera.project(at);
  context.strokeStyle = ink.color.accent;
  context.lineWidth = 2;
  context.beginPath();
  context.arc(x, y, 1.35 * BOB_RADIUS * scale, 0, 2 * Math.PI);
  context.stroke();
  // Fingers that come by flick the bob.
  if (!kiosk.value) drawArrow(context, ink);
}

/** Where the held bob is drawn. */
export function place(live: Live): Point {
  const { length } = live.given.pendulum;
  const [x, y, z] = live.hand.position;
  return placed(x / length, y / length, 1 - z / length, live.stretch);
}

/** From rest to where the bob is held. */
function arc(live: Live): Point[] {
  const [x, y, z] = place(live);
  const [aside, angle] = [Math.hypot(x, y), Math.atan2(Math.hypot(x, y), -z)];
  if (aside === 0) return [];
  return Array.from({ length: 25 }, (_, step) => {
    const part = (angle * step) / 24;
    return [(x / aside) * Math.sin(part), (y / aside) * Math.sin(part), -Math.cos(part)] as const;
  });
}

function drawFirstSwing(context: CanvasRenderingContext2D, camera: Camera, ink: Ink, live: Live, length: number): void {
  const times = Float64Array.from({ length: POINTS }, (_, index) => (live.period * index) / (POINTS - 1));
  const way = live.main.motion.positions(times);
  const pixels = [];
  for (let index = 0; index < POINTS; index++) {
    const [x = 0, y = 0, z = 0] = way.subarray(3 * index, 3 * index + 3);
    if (Number.isNaN(x)) break;
    pixels.push(camera.project(placed(x / length, y / length, 1 - z / length, live.stretch)));
  }
  context.strokeStyle = ink.color.exact;
  context.lineWidth = 2;
  context.setLineDash([2.5, 4.5]);
  trace(context, pixels);
  context.stroke();
}

export function drawArrow(context: CanvasRenderingContext2D, ink: Ink): void {
  const found = arrow();
  if (!found) return;
  const { from, tip } = found;
  const way = Math.hypot(tip[0] - from[0], tip[1] - from[1]) || 1;
  const [dx, dy] = [(tip[0] - from[0]) / way, (tip[1] - from[1]) / way];
  context.strokeStyle = ink.color.accent;
  context.lineWidth = 3.5;
  context.beginPath();
  context.moveTo(from[0] + 16 * dx, from[1] + 16 * dy);
  context.lineTo(tip[0] - 10 * dx, tip[1] - 10 * dy);
  context.stroke();
  context.lineWidth = 2.5;
  context.fillStyle = ink.color.paper;
  context.beginPath();
  context.arc(tip[0], tip[1], 10, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
  context.fillStyle = ink.color.accent;
  context.beginPath();
  context.moveTo(tip[0] + 5.5 * dx, tip[1] + 5.5 * dy);
  context.lineTo(tip[0] - 4 * dx - 4.5 * dy, tip[1] - 4 * dy + 4.5 * dx);
  context.lineTo(tip[0] - 4 * dx + 4.5 * dy, tip[1] - 4 * dy - 4.5 * dx);
  context.fill();
}

/** The sector that the plane has gone through, on the floor, from where it began. */
export function drawSector(context: CanvasRenderingContext2D, camera: Camera, ink: Ink, radius: number, from: number, turned: number): void {
  const size = 0.8 * radius;
  const shown = Math.max(-Math.PI, Math.min(Math.PI, turned));
  const steps = 40;
  context.fillStyle = faded(ink.color.accent, 0.13);
  for (const half of [0, Math.PI]) {
    const rim = Array.from({ length: steps + 1 }, (_, step) => {
      const angle = from + half + (shown * step) / steps;
      return camera.project([size * Math.cos(angle), size * Math.sin(angle), FLOOR]);
    });
    trace(context, [camera.project([0, 0, FLOOR]), ...rim]);
    context.closePath();
    context.fill();
  }
}

/** A straight line through the middle of the floor. */
export function drawBearing(context: CanvasRenderingContext2D, camera: Camera, radius: number, azimuth: number, color: string, width: number, dash: readonly number[]): void {
  const [x, y] = [radius * Math.cos(azimuth), radius * Math.sin(azimuth)];
  context.strokeStyle = color;
  context.lineWidth = width;
  context.setLineDash([...dash]);
  trace(context, [camera.project([x, y, FLOOR]), camera.project([-x, -y, FLOOR])]);
  context.stroke();
  context.setLineDash([]);
}
