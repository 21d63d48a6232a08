/** Whether the plane will stall: the sphere of all ellipses, its equator's band unrolled, and the answer. */

import { useEffect, useRef, useState } from "preact/hooks";
import { Refused, type Core, type EllipseNow, type Given, type PlaneSettled, type Portrait } from "../core";
import { faded, type Ink } from "../drawing/ink";
import { useDrawing } from "../instruments/canvas";
import { significant } from "../numbers/spell";
import type { Live } from "../state/live";
import { clock, core, duration, given, launches, live } from "../state/page";
import { ReadOut } from "../sentence/ReadOut";
import { language, words } from "../words/language";

/** Cells of the tint, lines through the band, and points of the path. */
const COLUMNS = 60;
const ROWS = 20;
const LINES = 9;
const PATH = 240;
const POINTS = 121;

/** A portrait is drawn anew when the swing has changed by so much. */
const CHANGED = 0.02;

interface Drawn {
  readonly live: Live;
  readonly end: number;
  readonly a: number;
  readonly portrait: Portrait;
  /** Circularity at the edge of the band. */
  readonly edge: number;
  readonly lines: readonly Float64Array[];
  readonly stalls: readonly boolean[];
}

let drawn: Drawn | null = null;

function portraitNow(engine: Core, now: Live, ellipse: EllipseNow): Drawn | null {
  if (drawn?.live === now && drawn.end === duration.value && Math.abs(ellipse.a / drawn.a - 1) < CHANGED) return drawn;
  try {
    const portrait = engine.portrait(now.given, ellipse);
    const edge = edgeOf(now, portrait);
    const at = (index: number, count: number): number => edge * ((2 * index) / (count - 1) - 1);
    const lines = Array.from({ length: LINES }, (_, index) => [0, Math.PI].map((longitude) => portrait.path({ circularity: at(index, LINES), longitude }, POINTS))).flat();
    const cells = new Float64Array(2 * COLUMNS * ROWS);
    for (let row = 0; row < ROWS; row++)
      for (let column = 0; column < COLUMNS; column++)
        cells.set([edge * (1 - (2 * (row + 0.5)) / ROWS), ((column + 0.5) / COLUMNS) * 2 * Math.PI - Math.PI], 2 * (row * COLUMNS + column));
    const stalls = portrait.verdicts(cells).map((verdict) => verdict !== "round");
    drawn = { live: now, end: duration.value, a: ellipse.a, portrait, edge, lines, stalls };
  } catch (error) {
    if (!(error instanceof Refused)) throw error;
    // A swing that has died away has no portrait any more.
    drawn = null;
  }
  return drawn;
}

/** The band takes in the whole way that the timeline shows, and the orbit where that is narrow enough to be seen with it. */
function edgeOf(now: Live, portrait: Portrait): number {
  const way = now.averaged?.reach(duration.value) ? wayOf(portrait, now, duration.value) : [];
  const widest = Math.max(0.004, Math.abs(portrait.form.circularity), ...way.map(({ u }) => Math.abs(u)));
  const orbit = Math.max(...portrait.orbit.limits.map(Math.abs));
  return Math.min(0.98, 1.2 * Math.max(widest, orbit < 4 * widest ? orbit : 0));
}

type Answer = "even" | "round" | "driven" | "stands" | "swings" | "ground" | "open";

/** The answer of the averaged motion, drag and drive included. */
function answerOf(engine: Core, job: Given, now: Live): Answer {
  if (now.settled.earth === 0) return "ground";
  if (now.settled.anisotropy === 0 && now.settled.dampingAnisotropy === 0) return "even";
  let found: PlaneSettled | null = null;
  try {
    found = engine.settles(job);
  } catch (error) {
    if (!(error instanceof Refused)) throw error;
  }
  if (!found) return "open";
  if (found.verdict === "stands") return "stands";
  if (found.verdict === "to and fro") return "swings";
  const ellipse = now.ellipse(0);
  const free = ellipse && portraitNow(engine, now, ellipse)?.portrait.orbit.verdict;
  return job.drive && free && free !== "round" ? "driven" : "round";
}

export function PortraitView() {
  const sphere = useRef<HTMLCanvasElement>(null);
  const band = useRef<HTMLCanvasElement>(null);
  const [answer, setAnswer] = useState<Answer | null>(null);
  const draw = (part: typeof drawSphere) => (context: CanvasRenderingContext2D, ink: Ink, width: number, height: number) => {
    const [engine, now] = [core.value, live.value];
    const ellipse = now?.ellipse(clock.time);
    context.clearRect(0, 0, width, height);
    if (typeof engine === "string" || !now || !ellipse || ellipse.a <= 0) return;
    const found = portraitNow(engine, now, ellipse);
    if (found) part(context, ink, width, height, found, now, clock.time);
  };
  useDrawing(sphere, draw(drawSphere));
  useDrawing(band, draw(drawBand));
  const count = launches.value;
  useEffect(() => {
    setAnswer(null);
    // It may look at weeks of the motion: not while somebody drags a ruler.
    const timer = setTimeout(() => {
      const [engine, now] = [core.value, live.value];
      if (typeof engine !== "string" && now?.mode === "foucault") setAnswer(answerOf(engine, given.value, now));
    }, 300);
    return () => clearTimeout(timer);
  }, [count]);
  const say = words.value.foucault;
  return (
    <section class="portrait" aria-label={say.stall}>
      <div class="heading">
        <h2>{say.stall}</h2>
        {answer && <ReadOut className="answer" value={say.answers[answer]} title={say.stall} text={say.why} />}
      </div>
      <div class="drawings">
        <canvas ref={sphere} class="sphere" aria-hidden="true" />
        <div class="band">
          <canvas ref={band} role="img" aria-label={`${say.stall} ${answer ? say.answers[answer] : ""}`} />
          <p>
            <span>−90°</span>
            <span>{say.tint}</span>
            <span>+90°</span>
          </p>
        </div>
      </div>
    </section>
  );
}

/** The path of the plane up to a time, as places on the sphere. */
function wayOf(portrait: Portrait, now: Live, time: number): { u: number; phi: number }[] {
  if (!now.averaged || time <= 0) return [];
  const times = Float64Array.from({ length: PATH }, (_, index) => (time * index) / (PATH - 1));
  const rows = now.averaged.ellipses(times);
  const found: { u: number; phi: number }[] = [];
  for (let index = 0; index < PATH; index++) {
    const [a = Number.NaN, b = 0, azimuth = 0] = rows.subarray(3 * index, 3 * index + 3);
    if (!(a > 0)) continue;
    const { circularity: u, longitude: phi } = portrait.place({ a, b, azimuth });
    found.push({ u, phi });
  }
  return found;
}

const wrapped = (angle: number): number => Math.atan2(Math.sin(angle), Math.cos(angle));

function drawBand(context: CanvasRenderingContext2D, ink: Ink, width: number, height: number, found: Drawn, now: Live, time: number): void {
  const { edge } = found;
  const toX = (phi: number): number => ((wrapped(phi) + Math.PI) / (2 * Math.PI)) * width;
  const toY = (u: number): number => (height / 2) * (1 - u / edge);
  context.save();
  context.beginPath();
  context.rect(0, 0, width, height);
  context.clip();
  context.fillStyle = faded(ink.color.accent, 0.06);
  context.fillRect(0, 0, width, height);
  context.fillStyle = faded(ink.color.stall, 0.2);
  found.stalls.forEach((stalls, index) => {
    if (!stalls) return;
    // Whole pixels, so that no seams show.
    const [left, right] = [0, 1].map((one) => Math.round((((index % COLUMNS) + one) * width) / COLUMNS)) as [number, number];
    const [top, bottom] = [0, 1].map((one) => Math.round(((Math.floor(index / COLUMNS) + one) * height) / ROWS)) as [number, number];
    context.fillRect(left, top, right - left, bottom - top);
  });
  const curve = (points: readonly { u: number; phi: number }[]): void => {
    context.beginPath();
    let before: number | null = null;
    for (const { u, phi } of points) {
      const x = toX(phi);
      if (before === null || Math.abs(x - before) > width / 2) context.moveTo(x, toY(u));
      else context.lineTo(x, toY(u));
      before = x;
    }
    context.stroke();
  };
  context.strokeStyle = faded(ink.color.soft, 0.75);
  context.lineWidth = 1;
  for (const line of found.lines) curve(Array.from({ length: line.length / 2 }, (_, index) => ({ u: line[2 * index] ?? 0, phi: line[2 * index + 1] ?? 0 })));
  context.beginPath();
  context.moveTo(0, height / 2);
  context.lineTo(width, height / 2);
  context.stroke();
  const way = wayOf(found.portrait, now, time);
  context.strokeStyle = ink.color.exact;
  context.lineWidth = 2.4;
  curve(way);
  const here = way.at(-1);
  if (here) dot(context, ink, toX(here.phi), toY(here.u));
  context.restore();
  context.strokeStyle = ink.color.edge;
  context.lineWidth = 1;
  context.strokeRect(0.5, 0.5, width - 1, height - 1);
  context.font = `500 ${ink.chartSize}px ${ink.sans}`;
  context.textBaseline = "middle";
  const share = Math.tan(Math.asin(edge) / 2);
  const text = (sign: string): string => `${sign === "+" ? "b/a = " : ""}${sign}${significant(100 * share, 2, language.value)} %`;
  for (const [sign, y] of [["+", 11], ["−", height - 11]] as const) {
    const wide = context.measureText(text(sign)).width;
    context.fillStyle = faded(ink.color.paper, 0.85);
    context.fillRect(3, y - 8, wide + 8, 16);
    context.fillStyle = ink.color.soft;
    context.fillText(text(sign), 7, y);
  }
}

function dot(context: CanvasRenderingContext2D, ink: Ink, x: number, y: number): void {
  context.beginPath();
  context.arc(x, y, 5.5, 0, 2 * Math.PI);
  context.fillStyle = ink.color.exact;
  context.fill();
  context.strokeStyle = ink.color.paper;
  context.lineWidth = 1.5;
  context.stroke();
}

/** The sphere for orientation: its equator are straight swings, its poles circles. */
function drawSphere(context: CanvasRenderingContext2D, ink: Ink, width: number, height: number, found: Drawn, now: Live, time: number): void {
  const radius = Math.min(width, height) / 2 - 3;
  const [cx, cy] = [width / 2, height / 2];
  const tilt = 0.3;
  const here = found.portrait.place(now.ellipse(time) ?? { a: 1, b: 0, azimuth: 0 });
  const at = (u: number, phi: number): { x: number; y: number; front: boolean } => {
    const ring = Math.sqrt(Math.max(0, 1 - u * u));
    const [right, toward] = [ring * Math.sin(phi - here.longitude + 0.5), ring * Math.cos(phi - here.longitude + 0.5)];
    return { x: cx + radius * right, y: cy - radius * (u * Math.cos(tilt) - toward * Math.sin(tilt)), front: toward * Math.cos(tilt) + u * Math.sin(tilt) >= 0 };
  };
  const light = context.createRadialGradient(cx - 0.3 * radius, cy - 0.4 * radius, 0.1 * radius, cx, cy, radius);
  light.addColorStop(0, ink.color.raised);
  light.addColorStop(1, ink.color.wash);
  context.fillStyle = light;
  context.beginPath();
  context.arc(cx, cy, radius, 0, 2 * Math.PI);
  context.fill();
  context.strokeStyle = ink.color.edge;
  context.lineWidth = 1;
  context.stroke();
  const line = (points: readonly { u: number; phi: number }[]): void => {
    context.beginPath();
    let open = false;
    for (const { u, phi } of points) {
      const { x, y, front } = at(u, phi);
      if (front && open) context.lineTo(x, y);
      else if (front) context.moveTo(x, y);
      open = front;
    }
    context.stroke();
  };
  const parallel = (u: number): { u: number; phi: number }[] => Array.from({ length: 73 }, (_, index) => ({ u, phi: (index / 72) * 2 * Math.PI }));
  context.strokeStyle = faded(ink.color.soft, 0.4);
  for (const u of [-0.75, -0.4, 0, 0.4, 0.75]) line(parallel(u));
  context.strokeStyle = ink.color.exact;
  context.setLineDash([3, 3]);
  for (const u of [-found.edge, found.edge]) line(parallel(u));
  context.setLineDash([]);
  context.lineWidth = 2.2;
  line(wayOf(found.portrait, now, time));
  const { x, y } = at(here.circularity, here.longitude);
  dot(context, ink, x, y);
}
