/** The motions that are seen now. They live in the core's memory until another launch takes their place. */

import { Refused, type Core, type EllipseNow, type Given, type Law, type Measured, type Motion, type Settled, type State, type Summary, type Trace } from "../core";
import { handOf, type Hand } from "./hand";

export interface Moving {
  readonly motion: Motion;
  readonly trace: Trace;
  /** s that its trace holds */
  readonly memory: number;
}

export const RUNGS = ["cubic", "ellipse", "linear"] as const;
export type Rung = (typeof RUNGS)[number];

export type Mode = "free" | "foucault" | "pair";

/** Swings that a trace holds, points in the time of a small one, points at most, and how much of a swing is drawn of the formulas. */
const SWINGS = 15;
const POINTS = 240;
const MOST_POINTS = 10_000;
const TAIL = 0.8;

/** Narrower swings than this, in units of the length, are drawn wider than they are. */
const SMALL = 0.25;
const DRAWN = 0.45;

/** The mode that follows from what is given: a circle on the turning ground is shown with its twin. */
export function modeOf({ site, launch }: Given): Mode {
  if (!site) return "free";
  return launch.kind === "apsides" && launch.b === launch.a ? "pair" : "foucault";
}

export class Live {
  readonly mode: Mode;
  readonly summary: Summary;
  readonly settled: Settled;
  readonly main: Moving;
  /** The twin that goes round the other way. */
  readonly twin: Moving | null = null;
  readonly averaged: Motion | null = null;
  readonly rungs = new Map<Rung, Moving>();
  readonly hand: Hand;
  /** s: of a swing, for the spacing of the trace and for speeds */
  readonly period: number;
  /** Furthest from the axis, in units of the length. */
  readonly reach: number;
  /** So many times as wide as it swings is it drawn. */
  readonly stretch: number;
  readonly high: boolean;
  private readonly measures = new Map<Rung, Measured | null>();

  /** Throws `Refused` for what cannot be launched; nothing is left behind then. */
  constructor(
    private readonly core: Core,
    readonly given: Given,
    rod: boolean,
    /** Kept while a hand holds the bob, so that it stays under the hand. */
    kept: number | null = null,
  ) {
    this.mode = modeOf(given);
    this.summary = core.summary(given);
    this.settled = core.settled(given);
    const swing = this.mode === "free" ? this.summary.swingPeriod : this.settled.smallPeriod;
    this.period = Number.isFinite(swing) ? Math.min(swing, 6 * this.settled.smallPeriod) : 3 * this.settled.smallPeriod;
    try {
      this.main = this.moving(given, this.mode === "free" ? "exact" : rod ? "rod" : "real", SWINGS);
      if (this.mode === "pair" && given.launch.kind === "apsides")
        this.twin = this.moving({ ...given, launch: { ...given.launch, b: -given.launch.b } }, rod ? "rod" : "real", SWINGS);
      if (this.mode === "foucault") this.averaged = core.motion(given, "averaged");
      if (this.mode === "free") this.addRungs();
    } catch (error) {
      this.free();
      throw error;
    }
    this.hand = handOf(this.main.motion.state(0) as State);
    this.high = this.mode === "free" && this.summary.largestAngle > Math.PI / 2;
    this.reach = this.high ? 1 : Math.max(this.mode === "free" ? this.summary.outer : this.hand.pull, 1e-9) / given.pendulum.length;
    this.stretch = kept ?? (!this.high && this.reach < SMALL && this.reach > 1e-8 ? rounded(DRAWN / this.reach) : 1);
  }

  /** Frequency and precession of a formula, found once; null where it cannot be launched. */
  measured(rung: Rung): Measured | null {
    let found = this.measures.get(rung);
    if (found === undefined) {
      try {
        found = this.rungs.has(rung) ? this.core.measured(this.given, rung) : null;
      } catch (error) {
        if (!(error instanceof Refused)) throw error;
        found = null;
      }
      this.measures.set(rung, found);
    }
    return found;
  }

  /** The mean ellipse at a time; null where the averaged motion has ended. */
  ellipse(time: number): EllipseNow | null {
    return this.averaged?.reach(time) ? this.averaged.ellipse(time) : null;
  }

  private widestUntil = { end: -1, whole: false, value: 0 };

  /** The largest |b| of the mean ellipse up to a time, m, as far as the core has gone. */
  widest(end: number): number {
    const motion = this.averaged;
    if (!motion) return 0;
    if (this.widestUntil.end !== end || !this.widestUntil.whole) {
      const whole = motion.reach(end) || motion.ended !== null;
      const rows = motion.ellipses(Float64Array.from({ length: 241 }, (_, index) => (end * index) / 240));
      let value = 0;
      for (let index = 1; index < rows.length; index += 3) value = Math.max(value, Math.abs(rows[index] || 0));
      this.widestUntil = { end, whole, value };
    }
    return this.widestUntil.value;
  }

  /** Brings all traces to a time; false where one is still on its way. */
  follow(time: number, beside: ReadonlySet<Rung>, besideOnly = false): boolean {
    let there = besideOnly || follow(this.main, time);
    if (this.twin) there = follow(this.twin, time) && there;
    for (const [rung, moving] of this.rungs) if (beside.has(rung)) follow(moving, time);
    return there;
  }

  free(): void {
    for (const one of [this.main, this.twin, ...this.rungs.values()]) {
      one?.trace.free();
      one?.motion.free();
    }
    this.averaged?.free();
  }

  private moving(given: Given, law: Law, swings: number): Moving {
    const motion = this.core.motion(given, law);
    // A swing that lingers on top is as fast as any below.
    const spacing = Math.min(this.period, this.settled.smallPeriod) / POINTS;
    const capacity = Math.min(MOST_POINTS, Math.round((swings * this.period) / spacing));
    return { motion, trace: motion.trace(spacing, capacity), memory: capacity * spacing };
  }

  private addRungs(): void {
    for (const rung of RUNGS) {
      try {
        this.rungs.set(rung, this.moving(this.given, rung, TAIL));
      } catch (error) {
        // It holds only below the support: its row says so.
        if (!(error instanceof Refused)) throw error;
      }
    }
  }
}

/** A trace that has been left elsewhere begins so far back that it is full at once. */
function follow({ trace, motion, memory }: Moving, time: number): boolean {
  if (trace.count === 0 || time < trace.time || time - trace.time > memory) {
    const from = Math.max(0, time - memory);
    if (!motion.reach(from)) return false;
    trace.restart();
    trace.follow(from);
  }
  return trace.follow(time);
}

/** To two digits, as an enlargement is said. */
function rounded(factor: number): number {
  return Number(factor.toPrecision(factor < 10 ? 1 : 2));
}
