/** The lit space, the support and the floor with its circle of degrees: what stays while the bob swings. */

import { DEGREE } from "../numbers/ladders";
import { FLOOR, type Camera, type Pixel } from "./camera";
import { faded, type Ink } from "./ink";

export interface FloorFigures {
  /** Four texts, at 0°, 90°, 180° and 270°. */
  readonly texts: readonly string[];
  readonly bold: boolean;
}

export function drawFloor(
  context: CanvasRenderingContext2D,
  camera: Camera,
  ink: Ink,
  radius: number,
  figures: FloorFigures,
  size: readonly [number, number],
): void {
  context.clearRect(0, 0, ...size);
  drawLight(context, camera, ink, size);
  drawDisc(context, camera, ink, radius);
  drawDegrees(context, camera, ink, radius, figures);
  drawSupport(context, camera, ink);
}

function drawLight(context: CanvasRenderingContext2D, camera: Camera, ink: Ink, [width, height]: readonly [number, number]): void {
  const middle = camera.project([0, 0, -0.7]);
  const light = context.createRadialGradient(middle.x, middle.y, 0, middle.x, middle.y, 0.8 * middle.scale);
  light.addColorStop(0, faded(ink.color.raised, 1));
  light.addColorStop(1, faded(ink.color.raised, 0));
  context.fillStyle = light;
  context.fillRect(0, 0, width, height);
}

function rim(camera: Camera, radius: number, height: number): Pixel[] {
  return Array.from({ length: 96 }, (_, step) => {
    const angle = (step / 96) * 2 * Math.PI;
    return camera.project([radius * Math.cos(angle), radius * Math.sin(angle), height]);
  });
}

export function trace(context: CanvasRenderingContext2D, pixels: readonly Pixel[]): void {
  context.beginPath();
  pixels.forEach(({ x, y }, index) => (index ? context.lineTo(x, y) : context.moveTo(x, y)));
}

function drawDisc(context: CanvasRenderingContext2D, camera: Camera, ink: Ink, radius: number): void {
  const [top, below] = [rim(camera, radius, FLOOR), rim(camera, radius, FLOOR - 0.03)];
  trace(context, below);
  context.closePath();
  context.fillStyle = ink.color["floor-side"];
  context.fill();
  const middle = camera.project([0, 0, FLOOR]);
  const shade = context.createRadialGradient(middle.x, middle.y, 0.2 * radius * middle.scale, middle.x, middle.y, radius * middle.scale);
  shade.addColorStop(0, ink.color.floor);
  shade.addColorStop(0.7, ink.color.floor);
  shade.addColorStop(1, ink.color["floor-edge"]);
  trace(context, top);
  context.closePath();
  context.fillStyle = shade;
  context.fill();
  context.strokeStyle = faded(ink.color["floor-ink"], 0.75);
  context.lineWidth = 1;
  context.stroke();
}

function drawDegrees(context: CanvasRenderingContext2D, camera: Camera, ink: Ink, radius: number, figures: FloorFigures): void {
  context.strokeStyle = ink.color["floor-ink"];
  for (let degree = 0; degree < 360; degree += 5) {
    const [x, y] = [Math.cos(degree * DEGREE), Math.sin(degree * DEGREE)];
    const main = degree % 30 === 0;
    const inner = radius * (main ? 0.93 : 0.965);
    const [from, to] = [camera.project([inner * x, inner * y, FLOOR]), camera.project([0.99 * radius * x, 0.99 * radius * y, FLOOR])];
    context.globalAlpha = main ? 1 : 0.6;
    context.lineWidth = main ? 1.8 : 1;
    context.beginPath();
    context.moveTo(from.x, from.y);
    context.lineTo(to.x, to.y);
    context.stroke();
  }
  context.globalAlpha = 1;
  context.fillStyle = ink.color["floor-ink"];
  const size = figures.bold ? ink.chartSize + 3 : ink.chartSize;
  context.font = `${figures.bold ? 600 : 500} ${size}px ${ink.sans}`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  figures.texts.forEach((text, index) => {
    const angle = (index * Math.PI) / 2;
    const at = camera.project([0.84 * radius * Math.cos(angle), 0.84 * radius * Math.sin(angle), FLOOR]);
    context.fillText(text, at.x, at.y);
  });
}

function drawSupport(context: CanvasRenderingContext2D, camera: Camera, ink: Ink): void {
  const at = camera.project([0, 0, 0]);
  const unit = Math.max(at.scale / 330, 0.7);
  const [half, top] = [40 * unit, at.y - 13 * unit];
  context.strokeStyle = ink.color.edge;
  context.lineWidth = 1.3;
  context.beginPath();
  context.moveTo(at.x - half, top);
  context.lineTo(at.x + half, top);
  for (let step = 0; step < 8; step++) {
    const x = at.x - half + (step + 0.35) * (half / 4);
    context.moveTo(x, top);
    context.lineTo(x + 6 * unit, top - 7 * unit);
  }
  context.stroke();
  const brass = context.createLinearGradient(at.x - 8 * unit, 0, at.x + 8 * unit, 0);
  brass.addColorStop(0, ink.color["brass-dark"]);
  brass.addColorStop(0.4, ink.color["brass-light"]);
  brass.addColorStop(1, ink.color["brass-dark"]);
  context.fillStyle = brass;
  context.beginPath();
  context.moveTo(at.x - 8 * unit, top);
  context.lineTo(at.x + 8 * unit, top);
  context.lineTo(at.x + 3.5 * unit, top + 17 * unit);
  context.lineTo(at.x - 3.5 * unit, top + 17 * unit);
  context.fill();
}
