import { faded } from "./ink";
import { FADE_STEPS, type Strand } from "./scene";

/** Draws a strand flat, fading from its newest to its oldest point, where `place` puts its points on the canvas. */
export function drawWay(
  context: CanvasRenderingContext2D,
  strand: Strand,
  width: number,
  place: (x: number, y: number, height: number) => readonly [number, number],
): void {
  const { ring, points } = strand;
  const count = ring ? ring.count : strand.count;
  if (count < 2) return;
  const capacity = ring ? ring.capacity : count;
  const last = ring ? ring.head : count - 1;
  context.lineWidth = width;
  context.lineCap = strand.dash[0] !== undefined && strand.dash[0] < 1 ? "round" : "butt";
  context.setLineDash([...strand.dash]);
  const steps = strand.alpha[0] === strand.alpha[1] ? 1 : FADE_STEPS;
  for (let step = steps - 1; step >= 0; step--) {
    const [from, to] = [Math.floor((step * (count - 1)) / steps), Math.floor(((step + 1) * (count - 1)) / steps)];
    const share = steps === 1 ? 0 : step / (steps - 1);
    context.strokeStyle = faded(strand.color, strand.alpha[0] + (strand.alpha[1] - strand.alpha[0]) * share);
    context.beginPath();
    for (let age = to; age >= from; age--) {
      const base = 3 * ((last - age + capacity) % capacity);
      const [x, y] = place(points[base] ?? 0, points[base + 1] ?? 0, points[base + 2] ?? 0);
      if (age === to) context.moveTo(x, y);
      else context.lineTo(x, y);
    }
    context.stroke();
  }
  context.setLineDash([]);
  context.lineCap = "butt";
}
