/** The path seen from above, in its circle of degrees. */

import { DEGREE } from "../numbers/ladders";
import { drawBrass, drawHollow } from "./brass";
import { faded, type Ink } from "./ink";
import type { Strand } from "./scene";
import type { Stroke } from "./strokes";
import { drawWay } from "./way";

export interface Squeeze {
  /** Azimuth of the long axis, rad, and how many times the width is drawn. */
  readonly azimuth: number;
  readonly factor: number;
}

export interface PlanLine {
  /** A straight line through the middle at this azimuth, or an ellipse about it; radii in units of the length. */
  readonly azimuth: number;
  readonly a: number;
  readonly b: number;
  readonly stroke: Stroke;
  readonly color: string;
  readonly alpha: number;
  readonly ends?: boolean;
}

export interface PlanBob {
  readonly x: number;
  readonly y: number;
  readonly ring: string | null;
  readonly alpha?: number;
}

export interface Plan {
  readonly ink: Ink;
  /** What is written around the circle, from 0° on, counter-clockwise. */
  readonly figures: readonly string[];
  /** Distance from the axis that is seen, in units of the length. */
  readonly reach: number;
  /** Outer and inner turning circle. */
  readonly circles: readonly number[];
  readonly strands: readonly Strand[];
  readonly lines: readonly PlanLine[];
  readonly bobs: readonly PlanBob[];
  readonly squeeze: Squeeze | null;
  /** Radius of the bob, px. */
  readonly bob: number;
}

/** px of the circle of degrees for a canvas of that size. */
export function ringRadius(size: number, ink: Ink): number {
  return size / 2 - 2.6 * ink.chartSize;
}

/** Where the outer turning circle lies in the circle of degrees. */
export const FILL = 0.875;

/** A place of the plan in px. */
export function placer(plan: Pick<Plan, "reach" | "squeeze" | "ink">, size: number): (x: number, y: number) => readonly [number, number] {
  const scale = (FILL * ringRadius(size, plan.ink)) / plan.reach;
  const [sin, cos] = [Math.sin(plan.squeeze?.azimuth ?? 0), Math.cos(plan.squeeze?.azimuth ?? 0)];
  const more = (plan.squeeze?.factor ?? 1) - 1;
  return (x, y) => {
    const across = more * (cos * y - sin * x);
    return [size / 2 + scale * (x - sin * across), size / 2 - scale * (y + cos * across)];
  };
}

export function drawPlan(context: CanvasRenderingContext2D, plan: Plan, size: number): void {
  context.clearRect(0, 0, size, size);
  const place = placer(plan, size);
  const ring = ringRadius(size, plan.ink);
  drawRing(context, plan, size, ring);
  drawCircles(context, plan, size, ring);
  // Lines say their own width: what is stretched along one axis is the way of the bob alone.
  const whole = placer({ ...plan, squeeze: null }, size);
  for (const line of plan.lines) drawLine(context, line, whole, plan);
  for (const strand of plan.strands) if (!strand.onFloor) drawWay(context, strand, 0.9 * strand.width, place);
  for (const bob of plan.bobs) {
    const [x, y] = place(bob.x, bob.y);
    if (bob.ring) drawHollow(context, x, y, 0.62 * plan.bob, plan.ink, bob.ring, 2.2);
    else drawBrass(context, x, y, plan.bob, plan.ink, bob.alpha);
  }
}

function drawRing(context: CanvasRenderingContext2D, { ink, figures }: Plan, size: number, radius: number): void {
  const middle = size / 2;
  context.strokeStyle = ink.color.edge;
  context.lineWidth = 1;
  context.beginPath();
  context.arc(middle, middle, radius, 0, 2 * Math.PI);
  context.stroke();
  for (let degree = 0; degree < 360; degree += 5) {
    const main = degree % 30 === 0;
    const [cos, sin] = [Math.cos(degree * DEGREE), Math.sin(degree * DEGREE)];
    const inner = radius - (main ? 9 : 5);
    context.globalAlpha = main ? 1 : 0.6;
    context.lineWidth = main ? 1.5 : 1;
    context.beginPath();
    context.moveTo(middle + inner * cos, middle - inner * sin);
    context.lineTo(middle + radius * cos, middle - radius * sin);
    context.stroke();
  }
  context.globalAlpha = 1;
  context.fillStyle = ink.color.soft;
  context.font = `500 ${ink.chartSize}px ${ink.sans}`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  figures.forEach((text, index) => {
    const angle = (index / figures.length) * 2 * Math.PI;
    const half = context.measureText(text).width / 2;
    const out = radius + 5 + half * Math.abs(Math.cos(angle)) + 0.6 * ink.chartSize * Math.abs(Math.sin(angle));
    context.fillText(text, middle + out * Math.cos(angle), middle - out * Math.sin(angle));
  });
}

function drawCircles(context: CanvasRenderingContext2D, plan: Plan, size: number, ring: number): void {
  context.strokeStyle = plan.ink.color.soft;
  context.lineWidth = 1.2;
  context.setLineDash([2, 4]);
  // Where the width is stretched, the inner circle is none any more.
  for (const radius of plan.squeeze ? plan.circles.slice(0, 1) : plan.circles) {
    if (radius <= 0) continue;
    context.beginPath();
    context.arc(size / 2, size / 2, (FILL * ring * radius) / plan.reach, 0, 2 * Math.PI);
    context.stroke();
  }
  context.setLineDash([]);
}

type Place = (x: number, y: number) => readonly [number, number];

function drawLine(context: CanvasRenderingContext2D, line: PlanLine, place: Place, plan: Plan): void {
  const [cos, sin] = [Math.cos(line.azimuth), Math.sin(line.azimuth)];
  context.strokeStyle = faded(line.color, line.alpha);
  context.lineWidth = line.stroke.width * plan.ink.weight;
  context.setLineDash([...line.stroke.dash]);
  context.beginPath();
  for (let step = 0; step <= 96; step++) {
    const angle = (step / 96) * 2 * Math.PI;
    const [u, v] = [line.a * Math.cos(angle), line.b * Math.sin(angle)];
    const [x, y] = place(cos * u - sin * v, sin * u + cos * v);
    if (step) context.lineTo(x, y);
    else context.moveTo(x, y);
    // A straight line is drawn once, so that its dashes stay apart.
    if (line.b === 0 && step === 48) break;
  }
  context.stroke();
  context.setLineDash([]);
  if (!line.ends) return;
  context.fillStyle = line.color;
  for (const sign of [1, -1]) {
    const [x, y] = place(sign * cos * line.a, sign * sin * line.a);
    context.beginPath();
    context.arc(x, y, 3.2, 0, 2 * Math.PI);
    context.fill();
  }
}
