/** The path seen from above, with its turning circles; a narrow ellipse is stretched, and said to be. */

import { useRef } from "preact/hooks";
import type { Ink } from "../drawing/ink";
import { drawPlan, FILL, placer, ringRadius, type Plan, type PlanLine, type Squeeze } from "../drawing/plan";
import { EARTH, STROKES } from "../drawing/strokes";
import { DEGREE } from "../numbers/ladders";
import { quantity } from "../numbers/spell";
import { meetingNow } from "../state/curves";
import type { Live } from "../state/live";
import { averaging, beside, clock, duration, given, gripped, launches, live, mode, shownTime, waiting } from "../state/page";
import { cancel, grip, hold, release } from "../stage/grip";
import { earlier } from "../stage/averaged";
import { held, moving } from "../stage/strands";
import { arrived } from "../stage/travel";
import { fill, language, words } from "../words/language";
import { useDrawing } from "./canvas";

/** Narrower ellipses than this, in their own length, are stretched until they are about so wide. */
const NARROW = 0.1;
const SHOWN = 0.25;
const STEPS = [100, 50, 20, 10, 5, 2];

/** By how much the width is stretched now, and along which axis. */
export function squeezeOf(now: Live, time: number): Squeeze | null {
  if (gripped.value) return null;
  if (now.mode === "free") {
    const { inner, outer, turning, regime } = now.summary;
    if (regime !== "ellipse" || inner >= NARROW * outer) return null;
    return stretched(now.hand.azimuth + turning * time, inner / outer);
  }
  if (now.mode === "pair") return null;
  const ellipse = now.ellipse(time);
  if (!ellipse || ellipse.a <= 0) return null;
  return stretched(ellipse.azimuth, now.widest(duration.value) / now.hand.pull);
}

function stretched(azimuth: number, share: number): Squeeze | null {
  const factor = share > 0 ? STEPS.find((one) => one * share <= SHOWN) : undefined;
  return share < NARROW && factor ? { azimuth, factor } : null;
}

function figures(): readonly string[] {
  if (mode.value === "free") return Array.from({ length: 12 }, (_, index) => `${30 * index}°`);
  if (Math.abs(given.value.site?.latitude ?? 0) > 89.99 * DEGREE) return ["0°", "90°", "180°", "270°"];
  const [north = "N", east = "E", south = "S", west = "W"] = words.value.foucault.compass;
  return [east, north, west, south];
}

function planOf(now: Live, ink: Ink, width: number): Plan {
  const time = clock.time;
  const squeeze = squeezeOf(now, time);
  const base = { ink, figures: figures(), reach: now.reach, squeeze, bob: Math.min(0.8 * ink.chartSize, width / 20) };
  const { length } = now.given.pendulum;
  // It begins to be drawn when the bob has come to it.
  if (waiting.value && !gripped.value && !arrived()) return { ...base, circles: [], strands: [], lines: [], bobs: [] };
  if (averaging.value && !gripped.value) return { ...base, circles: [], strands: [], ...averagedPlan(now, time, ink, squeeze?.factor ?? 1) };
  const state = gripped.value ? now.main.motion.state(0) : null;
  const seen = state ? held(now, state) : moving(now, beside.value, ink);
  const { inner, outer } = now.summary;
  const circles = now.mode === "free" ? (now.high ? [] : [outer / length, inner / length]) : [];
  const lines: PlanLine[] = now.mode === "free" ? [] : [earth(now, time, ink), ...met(now, ink)];
  // Where older swings lay otherwise, stretching them along today's axis would show a turning that is none.
  const strands = squeeze && now.mode === "foucault" ? seen.strands.map((one) => ({ ...one, ring: one.ring && { ...one.ring, count: Math.min(one.ring.count, 480) } })) : seen.strands;
  return { ...base, circles, strands, lines, bobs: seen.places };
}

function earth(now: Live, time: number, ink: Ink): PlanLine {
  return { azimuth: now.hand.azimuth + now.settled.earth * time, a: now.reach, b: 0, stroke: EARTH, color: ink.color[EARTH.ink], alpha: 1 };
}

/** The line on which two bobs meet. */
function met(now: Live, ink: Ink): PlanLine[] {
  const azimuth = meetingNow(now);
  if (azimuth === null) return [];
  return [{ azimuth, a: now.reach / FILL, b: 0, stroke: { ...STROKES.exact, width: 1.6 }, color: ink.color.exact, alpha: 1, ends: true }];
}

function averagedPlan(now: Live, time: number, ink: Ink, factor: number): Pick<Plan, "lines" | "bobs"> {
  const ellipse = now.ellipse(time);
  if (!ellipse) return { lines: [], bobs: [] };
  const { length } = now.given.pendulum;
  const stroke = STROKES.exact;
  const color = ink.color.exact;
  const past = earlier(now, time).ellipses.slice(-24);
  const lines: PlanLine[] = past.map((one) => ({ azimuth: one.azimuth, a: one.a / length, b: (factor * one.b) / length, stroke: { ...stroke, width: 0.8 }, color, alpha: 0.3 }));
  lines.push({ azimuth: ellipse.azimuth, a: now.reach / FILL, b: 0, stroke: { ...stroke, width: 1.2 }, color, alpha: 0.9, ends: true });
  lines.push(earth(now, time, ink));
  lines.push({ azimuth: ellipse.azimuth, a: ellipse.a / length, b: (factor * ellipse.b) / length, stroke: { ...stroke, width: 3 }, color, alpha: 1 });
  const [x, y] = [(ellipse.a / length) * Math.cos(ellipse.azimuth), (ellipse.a / length) * Math.sin(ellipse.azimuth)];
  return { lines, bobs: [{ x, y, ring: null }, { x: -x, y: -y, ring: null }] };
}

export function PlanView() {
  const canvas = useRef<HTMLCanvasElement>(null);
  const handle = useRef<HTMLDivElement>(null);
  const dragging = useRef(false);
  const view = useRef<{ plan: Plan; size: number } | null>(null);
  useDrawing(canvas, (context, ink, width) => {
    const now = live.value;
    if (!now) return;
    const plan = planOf(now, ink, width);
    drawPlan(context, plan, width);
    view.current = { plan, size: width };
    const bob = plan.bobs.at(-1);
    if (!bob || !handle.current) return;
    const [x, y] = placer(plan, width)(bob.x, bob.y);
    handle.current.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
  });
  void [shownTime.value, launches.value];
  const now = live.value;
  const say = words.value.plan;
  const squeeze = now && squeezeOf(now, shownTime.value);
  const factor = String(squeeze?.factor ?? 1);
  const reach = (value: number): string => quantity(value, "m", 3, language.value);
  const text = now ? fill(say.describe, { inner: reach(now.mode === "free" ? now.summary.inner : 0), outer: reach(now.mode === "free" ? now.summary.outer : now.hand.pull) }) : "";

  /** Drags the bob in the plan: exact for small swings, since the height follows. */
  const drag = (event: PointerEvent): void => {
    const shown = view.current;
    const [held, area] = [live.value, canvas.current?.getBoundingClientRect()];
    if (!dragging.current || !shown || !held || !area) return;
    const scale = (FILL * ringRadius(shown.size, shown.plan.ink)) / shown.plan.reach;
    const { length } = held.given.pendulum;
    const [x, y] = [(event.clientX - area.left - shown.size / 2) / scale, (shown.size / 2 - event.clientY + area.top) / scale];
    const share = Math.min(1, (mode.value === "free" ? 0.98 : 0.5) / Math.hypot(x, y));
    const [px, py] = [x * share, y * share];
    hold([px * length, py * length, length * Math.sqrt(1 - px * px - py * py)]);
  };
  return (
    <section class="plan" aria-label={say.label}>
      <div class="heading">
        <h2>{say.label}</h2>
        {squeeze && (
          <span class="stretch" title={fill(say.widthHelp, { factor })}>
            {fill(say.width, { factor })}
          </span>
        )}
      </div>
      <div class="canvas">
        <canvas ref={canvas} role="img" aria-label={text} />
        <div
          ref={handle}
          class="drag"
          onPointerDown={(event) => {
            event.currentTarget.setPointerCapture(event.pointerId);
            dragging.current = true;
            grip();
          }}
          onPointerMove={drag}
          onPointerUp={() => {
            dragging.current = false;
            release();
          }}
          onPointerCancel={() => {
            dragging.current = false;
            cancel();
          }}
        />
      </div>
    </section>
  );
}
