/** The bob on a canvas: the one thing on the page that is brass. */

import { faded, type Ink } from "./ink";

export function drawBrass(context: CanvasRenderingContext2D, x: number, y: number, radius: number, ink: Ink, alpha = 1): void {
  const light = context.createRadialGradient(x - 0.35 * radius, y - 0.4 * radius, 0.05 * radius, x, y, radius);
  light.addColorStop(0, ink.color["brass-light"]);
  light.addColorStop(0.42, ink.color.brass);
  light.addColorStop(1, ink.color["brass-dark"]);
  context.globalAlpha = alpha;
  context.fillStyle = light;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fill();
  context.globalAlpha = 1;
}

/** The bob of an approximation: a ring, filled with paper so that it can be told from its line. */
export function drawHollow(context: CanvasRenderingContext2D, x: number, y: number, radius: number, ink: Ink, color: string, width: number): void {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fillStyle = faded(ink.color.paper, 0.85);
  context.fill();
  context.strokeStyle = color;
  context.lineWidth = width;
  context.stroke();
}
