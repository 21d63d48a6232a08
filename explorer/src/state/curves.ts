/** The curves of the timeline: which way the ellipse lies, of each motion that is shown. */

import type { Ink } from "../drawing/ink";
import { EARTH, STROKES, type Drawn } from "../drawing/strokes";
import type { Curve } from "../drawing/timeline";
import { rate, type Language } from "../numbers/spell";
import type { Words } from "../words/en";
import { RUNGS, type Live, type Rung } from "./live";
import { shownTime } from "./page";

/** Points of a curve that bends, and turning points that are still marked one by one. */
const POINTS = 361;
const MARKED = 130;

export interface CurveRequest {
  readonly live: Live;
  readonly end: number;
  readonly deviation: boolean;
  readonly beside: ReadonlySet<Rung>;
  readonly ink: Ink;
  readonly words: Words;
  readonly language: Language;
}

export interface Curves {
  readonly curves: readonly Curve[];
  /** False where the core is still on its way to the end. */
  readonly whole: boolean;
}

export function curvesOf(request: CurveRequest): Curves {
  const { mode } = request.live;
  if (mode === "free") return { curves: freeCurves(request), whole: true };
  return mode === "pair" ? pairCurves(request) : planeCurves(request);
}

/** Whether there is a direction to be shown. */
export function hasDirection(live: Live): boolean {
  return live.mode !== "free" || ["ellipse", "cone", "above"].includes(live.summary.regime);
}

function freeCurves({ live, end, deviation, beside, ink, words, language }: CurveRequest): Curve[] {
  if (!hasDirection(live)) return [];
  const { summary } = live;
  const points = end / summary.radialPeriod <= MARKED ? live.main.motion.turningPoints(0, end, MARKED + 2) : [];
  const first = points[0];
  const start = first ? live.hand.azimuth : 0;
  const found: Curve[] = [];
  const add = (drawn: Drawn, turning: number, dotted: boolean): void => {
    const marked = dotted && points.length > 1;
    const times = marked ? Float64Array.from([...points.map((one) => one.time), end]) : Float64Array.of(0, end);
    const slope = deviation ? turning - summary.turning : turning;
    const values = times.map((time) => (deviation ? 0 : start) + slope * time);
    const stroke = STROKES[drawn];
    const name = drawn === "ellipse" ? words.formulas.ellipseShort : words.formulas[drawn];
    found.push({ stroke, color: ink.color[stroke.ink], label: `${name} ${signed(turning, language)}`, times, values, dots: marked });
  };
  add("exact", summary.turning, !deviation);
  for (const rung of RUNGS) {
    if (!beside.has(rung) || !live.rungs.has(rung)) continue;
    // The ellipse of (16) stays where it is.
    const turning = rung === "linear" ? 0 : live.measured(rung)?.precession;
    if (turning !== null && turning !== undefined) add(rung, turning, false);
  }
  return found;
}

function signed(turning: number, language: Language): string {
  if (turning === 0) return "0";
  return `${turning < 0 ? "−" : ""}${rate(turning, 3, language)}`;
}

function planeCurves({ live, end, deviation, ink, words }: CurveRequest): Curves {
  const motion = live.averaged;
  if (!motion) return { curves: [], whole: true };
  const whole = motion.reach(end);
  const times = Float64Array.from({ length: POINTS }, (_, index) => (end * index) / (POINTS - 1));
  const plane = motion.azimuths(times);
  const start = live.hand.azimuth;
  const earth = times.map((time) => start + live.settled.earth * time);
  // The core counts from its own branch on; here the plane begins where the bob was let go.
  const first = plane.find((one) => !Number.isNaN(one)) ?? 0;
  const shift = Math.round((start - first) / Math.PI) * Math.PI;
  return {
    whole: whole || motion.ended !== null,
    curves: [
      { stroke: STROKES.exact, color: ink.color.exact, label: words.time.plane, times, values: plane.map((one, index) => one + shift - (deviation ? (earth[index] ?? 0) : 0)), dots: false },
      { stroke: EARTH, color: ink.color[EARTH.ink], label: words.time.earth, times, values: deviation ? earth.map(() => 0) : earth, dots: false },
    ],
  };
}

/** Half the sum of both azimuths: the line on which the two bobs meet. */
export function meeting(live: Live, times: Float64Array): Float64Array<ArrayBuffer> {
  const [one, other] = [live.main.motion, live.twin?.motion].map((motion) => motion?.positions(times));
  let before = live.hand.azimuth;
  return Float64Array.from({ length: times.length }, (_, index) => {
    const angle = (places: Float64Array | undefined): number => Math.atan2(places?.[3 * index + 1] ?? Number.NaN, places?.[3 * index] ?? Number.NaN);
    const half = (angle(one) + angle(other)) / 2;
    if (Number.isNaN(half)) return Number.NaN;
    before = half + Math.round((before - half) / Math.PI) * Math.PI;
    return before;
  });
}

let metAt: { readonly live: Live; readonly time: number; readonly azimuth: number } | null = null;

/** Where two bobs meet at the time that is said, rad; null where there is no twin. */
export function meetingNow(live: Live): number | null {
  if (!live.twin) return null;
  const time = shownTime.value;
  if (metAt?.live !== live || metAt.time !== time) {
    // From place to place it is followed, so that half a turn is not lost.
    const times = Float64Array.from({ length: 33 }, (_, index) => (time * index) / 32);
    metAt = { live, time, azimuth: meeting(live, times).at(-1) ?? Number.NaN };
  }
  return Number.isNaN(metAt.azimuth) ? null : metAt.azimuth;
}

function pairCurves({ live, end, deviation, ink, words }: CurveRequest): Curves {
  const whole = [live.main.motion, live.twin?.motion].every((motion) => motion?.reach(end) ?? true);
  const times = Float64Array.from({ length: POINTS }, (_, index) => (end * index) / (POINTS - 1));
  const met = whole ? meeting(live, times) : times.map(() => Number.NaN);
  const earth = times.map((time) => live.hand.azimuth + live.settled.earth * time);
  return {
    whole,
    curves: [
      { stroke: STROKES.exact, color: ink.color.exact, label: words.time.meeting, times, values: deviation ? met.map((one, index) => one - (earth[index] ?? 0)) : met, dots: false },
      { stroke: EARTH, color: ink.color[EARTH.ink], label: words.time.earth, times, values: deviation ? earth.map(() => 0) : earth, dots: false },
    ],
  };
}
