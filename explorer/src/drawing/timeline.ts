/** Azimuth against time: the curve that is also the bar to seek in. */

import { DAY, DEGREE, HOUR, MINUTE } from "../numbers/ladders";
import { faded, type Ink } from "./ink";
import type { Stroke } from "./strokes";

export interface Curve {
  readonly stroke: Stroke;
  readonly color: string;
  readonly label: string;
  readonly times: Float64Array;
  /** rad; what is not a number is left out. */
  readonly values: Float64Array;
  /** Whether each point is marked: the turning points. */
  readonly dots: boolean;
}

export interface Timeline {
  readonly ink: Ink;
  readonly curves: readonly Curve[];
  readonly now: number;
  readonly end: number;
  /** What stands in the handle's flag. */
  readonly flag: string;
  /** px kept free on the right for the labels of the curves; 0 for none. */
  readonly labels: number;
  readonly say: {
    readonly angle: (value: number, decimals: number) => string;
    readonly time: (value: number, unit: "s" | "min" | "h" | "d", decimals: number) => string;
  };
  /** When the motion stopped, s. */
  readonly ended: number | null;
}

export interface Band {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/** Where in a canvas of that size time runs. */
export function band(ink: Ink, labels: number, width: number, height: number): Band {
  return { left: 4.2 * ink.chartSize, right: width - labels - 1.6 * ink.chartSize, top: 1.1 * ink.chartSize, bottom: height - 2.1 * ink.chartSize };
}

/** A step of 1, 2 or 5 times a power of ten that is at least so large. */
function niceStep(least: number): number {
  const power = 10 ** Math.floor(Math.log10(least));
  return power * ([1, 2, 5, 10].find((one) => one * power >= least * (1 - 1e-9)) ?? 10);
}

/** Steps between the lines of angles: those that divide a turn, and decimal ones below a degree. */
function angleStep(range: number, most: number): number {
  const least = range / most / DEGREE;
  const found = [1, 2, 5, 10, 15, 30, 45, 90, 180, 360, 720, 1440, 3600].find((one) => one >= least);
  return (least < 1 ? niceStep(least) : (found ?? niceStep(least))) * DEGREE;
}

function timeStep(range: number, most: number): { step: number; unit: "s" | "min" | "h" | "d"; size: number } {
  const least = range / most;
  if (least > 12 * HOUR) return { step: niceStep(least / DAY) * DAY, unit: "d", size: DAY };
  const steps = [1, 2, 5, 10, 15, 20, 30, 60, 120, 300, 600, 900, 1800].filter((one) => range < 600 || one >= 60);
  if (range >= 2.5 * HOUR) {
    const hours = [0.5, 1, 2, 3, 6, 12].find((one) => one * HOUR >= least) ?? 12;
    return { step: hours * HOUR, unit: "h", size: HOUR };
  }
  const step = least < 1 ? niceStep(least) : (steps.find((one) => one >= least) ?? 1800);
  return range < 600 ? { step, unit: "s", size: 1 } : { step, unit: "min", size: MINUTE };
}

export function drawTimeline(context: CanvasRenderingContext2D, timeline: Timeline, width: number, height: number): void {
  const { ink, curves, end, now } = timeline;
  context.clearRect(0, 0, width, height);
  const area = band(ink, timeline.labels, width, height);
  const [low, high] = extent(curves);
  const toX = (time: number): number => area.left + ((area.right - area.left) * time) / end;
  const toY = (value: number): number => area.bottom - ((area.bottom - area.top) * (value - low)) / (high - low);
  context.font = `500 ${ink.chartSize}px ${ink.sans}`;
  drawAxes(context, timeline, area, [low, high], toX, toY);
  for (const curve of [...curves].reverse()) {
    drawCurve(context, curve, ink, toX, toY, now, end);
  }
  drawLabels(context, timeline, area, toY);
  drawHandle(context, timeline, area, toX);
}

function extent(curves: readonly Curve[]): readonly [number, number] {
  let [low, high] = [0, 0];
  for (const { values } of curves)
    for (const value of values) {
      if (value < low) low = value;
      if (value > high) high = value;
    }
  if (high - low < 1e-12) high = low + DEGREE;
  const room = 0.06 * (high - low);
  return [low < 0 ? low - room : low, high > 0 ? high + room : high];
}

type Scale = (value: number) => number;

function drawAxes(context: CanvasRenderingContext2D, { ink, end, say }: Timeline, area: Band, [low, high]: readonly [number, number], toX: Scale, toY: Scale): void {
  context.lineWidth = 1;
  context.textBaseline = "middle";
  context.textAlign = "right";
  const step = angleStep(high - low, Math.max(1, Math.floor((area.bottom - area.top) / (1.45 * ink.chartSize))));
  const decimals = Math.max(0, -Math.floor(Math.log10(step / DEGREE) + 1e-9));
  for (let index = Math.ceil(low / step - 1e-9); index * step <= high * (1 + 1e-9); index++) {
    const y = toY(index * step);
    context.strokeStyle = ink.color.line;
    context.beginPath();
    context.moveTo(area.left, y);
    context.lineTo(area.right, y);
    context.stroke();
    context.fillStyle = ink.color.soft;
    context.fillText(say.angle(index * step, decimals), area.left - 8, y);
  }
  context.textAlign = "center";
  const tick = timeStep(end, Math.max(2, Math.floor((area.right - area.left) / (5.4 * ink.chartSize))));
  for (let time = 0; time <= end * (1 + 1e-9); time += tick.step) {
    const x = toX(time);
    context.strokeStyle = ink.color.edge;
    context.beginPath();
    context.moveTo(x, area.bottom);
    context.lineTo(x, area.bottom + 4);
    context.stroke();
    const places = tick.step / tick.size < 1 ? Math.ceil(-Math.log10(tick.step / tick.size)) : 0;
    context.fillText(say.time(time / tick.size, tick.unit, places), x, area.bottom + 1.25 * ink.chartSize);
  }
}

function drawCurve(context: CanvasRenderingContext2D, curve: Curve, ink: Ink, toX: Scale, toY: Scale, now: number, end: number): void {
  const { times, values, stroke } = curve;
  const way = (from: number, to: number): void => {
    context.save();
    context.beginPath();
    context.rect(toX(from) - (from === 0 ? 4 : 0), -10, toX(to) - toX(from) + (from === 0 ? 4 : 0), 1e4);
    context.clip();
    context.beginPath();
    let open = false;
    for (let index = 0; index < times.length; index++) {
      const [time, value] = [times[index] ?? 0, values[index] ?? Number.NaN];
      if (Number.isNaN(value)) open = false;
      else if (open) context.lineTo(toX(time), toY(value));
      else {
        context.moveTo(toX(time), toY(value));
        open = true;
      }
    }
    context.stroke();
    if (curve.dots) {
      context.fillStyle = context.strokeStyle;
      context.beginPath();
      for (let index = 0; index < times.length; index++) {
        const [x, y] = [toX(times[index] ?? 0), toY(values[index] ?? 0)];
        context.moveTo(x + 2.6, y);
        context.arc(x, y, 2.6, 0, 2 * Math.PI);
      }
      context.fill();
    }
    context.restore();
  };
  context.lineWidth = Math.max(1.7, 0.85 * stroke.width) * ink.weight;
  context.lineCap = stroke.dash[0] !== undefined && stroke.dash[0] < 1 ? "round" : "butt";
  context.setLineDash([...stroke.dash]);
  context.strokeStyle = faded(curve.color, 1);
  way(0, Math.min(now, end));
  context.strokeStyle = faded(curve.color, 0.32);
  if (now < end) way(Math.min(now, end), end);
  context.setLineDash([]);
  context.lineCap = "butt";
}

function drawLabels(context: CanvasRenderingContext2D, { ink, curves, labels }: Timeline, area: Band, toY: Scale): void {
  if (!labels) return;
  context.textAlign = "left";
  context.textBaseline = "middle";
  const pitch = Math.min(1.3 * ink.chartSize, (area.bottom - 0.6 * ink.chartSize) / Math.max(1, curves.length - 1));
  const wanted = curves
    .map((curve) => ({ curve, y: toY([...curve.values].reverse().find((one) => !Number.isNaN(one)) ?? 0) }))
    .sort((first, second) => first.y - second.y);
  // Labels that would lie on one another move apart, and the lowest stays above the figures of time.
  for (let pass = 0; pass < 40; pass++)
    for (let index = 1; index < wanted.length; index++) {
      const [upper, lower] = [wanted[index - 1], wanted[index]];
      if (!upper || !lower || lower.y - upper.y >= pitch) continue;
      const push = (pitch - lower.y + upper.y) / 2;
      upper.y -= push;
      lower.y += push;
    }
  const over = Math.max(0, (wanted.at(-1)?.y ?? 0) - area.bottom);
  for (const one of wanted) one.y -= over;
  const under = Math.max(0, 0.6 * ink.chartSize - (wanted[0]?.y ?? 0));
  for (const { curve, y } of wanted) {
    const x = area.right + 7;
    context.strokeStyle = curve.color;
    context.lineWidth = 2.2;
    context.setLineDash([...curve.stroke.dash]);
    context.lineCap = curve.stroke.dash[0] !== undefined && curve.stroke.dash[0] < 1 ? "round" : "butt";
    context.beginPath();
    context.moveTo(x, y + under);
    context.lineTo(x + 19, y + under);
    context.stroke();
    context.setLineDash([]);
    context.fillStyle = ink.color.ink;
    context.fillText(curve.label, x + 25, y + under);
  }
  context.lineCap = "butt";
}

function drawHandle(context: CanvasRenderingContext2D, { ink, now, end, flag, ended }: Timeline, area: Band, toX: Scale): void {
  if (ended !== null && ended <= end) {
    context.strokeStyle = ink.color.cubic;
    context.lineWidth = 2;
    context.setLineDash([3, 3]);
    context.beginPath();
    context.moveTo(toX(ended), 0);
    context.lineTo(toX(ended), area.bottom);
    context.stroke();
    context.setLineDash([]);
  }
  const x = toX(Math.min(now, end));
  context.strokeStyle = ink.color.ink;
  context.lineWidth = 1.5;
  context.beginPath();
  context.moveTo(x, 0.9 * ink.chartSize);
  context.lineTo(x, area.bottom);
  context.stroke();
  context.fillStyle = ink.color.ink;
  context.beginPath();
  context.arc(x, area.bottom, 7.5, 0, 2 * Math.PI);
  context.fill();
  context.fillStyle = ink.color.paper;
  context.beginPath();
  context.arc(x, area.bottom, 2.6, 0, 2 * Math.PI);
  context.fill();
  context.font = `600 ${ink.chartSize + 1}px ${ink.sans}`;
  const wide = context.measureText(flag).width + 18;
  const left = Math.min(Math.max(x - wide / 2, area.left - 6), area.right + 8 - wide / 2);
  context.fillStyle = ink.color.ink;
  context.beginPath();
  context.roundRect(left, 0, wide, 1.65 * ink.chartSize, 6);
  context.fill();
  context.fillStyle = ink.color.paper;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillText(flag, left + wide / 2, 0.86 * ink.chartSize);
}
