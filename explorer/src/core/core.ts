import type { Given, Vector } from "./given";

/** What the page asks of the core. All in SI; azimuths and rates positive counter-clockwise seen from above. */
export interface Core {
  /** The words of all that it may refuse, such as "too_strong". */
  readonly refusalKinds: readonly string[];
  /** Throws `Refused` for what cannot be launched. */
  motion(given: Given, law: Law): Motion;
  /** The numbers of the ideal motion that starts like this one. Throws `Refused`. */
  summary(given: Given): Summary;
  /** The pendulum that swings once everything is settled, and what the Earth alone would do. Throws `Refused`. */
  settled(given: Given): Settled;
  /** Frequency and precession of a law, measured at its turning points, and their relative errors. Throws `Refused`. */
  measured(given: Given, law: Law): Measured;

  /** Where a ray meets the sphere on the near side or, where it misses, the point of the silhouette that is nearest. */
  nearestPlace(length: number, eye: Vector, direction: Vector): Vector;
  /** The launch of that place with that velocity, its part along the thread taken away. */
  nearestState(length: number, position: Vector, velocity: Vector): StateLaunch;

  /** The sphere of all ellipses of this size in this clamp. `b` with the sign of the sense. Throws `Refused`. */
  portrait(given: Given, ellipse: EllipseNow): Portrait;
  /** What the plane comes to in the end with all that acts, by the averaged motion; null where it cannot be told. Throws `Refused`. */
  settles(given: Given): PlaneSettled | null;
  /** The core's memory: it does not grow from frame to frame. */
  readonly memory: WebAssembly.Memory;
}

export type StateLaunch = { readonly kind: "state"; readonly position: Vector; readonly velocity: Vector };

/**
 * The law of a motion: exact; linear (16); turning ellipse (20); cubic (13); averaged over the swings
 * and real, both with all that acts. "rod" is the real one on a rod.
 */
export type Law = "exact" | "linear" | "ellipse" | "cubic" | "averaged" | "real" | "rod";

/** A motion from its launch on. It lives in the core's memory: `free` it. */
export interface Motion {
  readonly law: Law;
  /** Goes on to a time, s, in work of some milliseconds: false where it is not yet there, to be asked again. */
  reach(time: number): boolean;
  /** The bob at a time, s. What lies beyond an end is null. */
  state(time: number): State | null;
  /** x, y, z in m at each time, new numbers; NaN beyond an end. */
  positions(times: Float64Array): Float64Array<ArrayBuffer>;
  /** The same as it is drawn, at start + step·k, in units of the length: x, y, 1 − cos θ. */
  drawn(start: number, step: number, count: number): Float32Array<ArrayBuffer>;
  /** Of the major axis, rad, continuous from the first of the ascending times on; NaN beyond an end and without an axis. */
  azimuths(times: Float64Array): Float64Array<ArrayBuffer>;
  /** Distances from another motion, m, at each time. */
  distances(other: Motion, times: Float64Array): Float64Array<ArrayBuffer>;
  /** a, b, azimuth at each time, as of `ellipse`; the azimuth continuous. */
  ellipses(times: Float64Array): Float64Array<ArrayBuffer>;
  /** The ellipse at a time: osculating, and of the averaged motion its mean one. */
  ellipse(time: number): EllipseNow | null;
  /** Outer turning points from one time to another, at most `most`: time, place and azimuth. */
  turningPoints(from: number, to: number, most: number): TurningPoint[];
  /** What turns the plane at a time, rad/s; of the averaged motion only, else null. */
  shares(time: number): Shares | null;
  /** When and why the motion ends, where that has been seen. */
  readonly ended: { readonly time: number; readonly why: Ending } | null;
  /** A trace of this motion: points `spacing` seconds apart, `capacity` of them. */
  trace(spacing: number, capacity: number): Trace;
  free(): void;
}

/** The thread goes slack; the bob comes level with the support; backwards in time, the speed grows beyond all bounds. */
export type Ending = "slack" | "level" | "runaway";

export interface State {
  readonly position: Vector;
  readonly velocity: Vector;
  /** 1 − cos θ, with all its digits */
  readonly height: number;
  /** N; negative where only a rod holds it */
  readonly tension: number;
}

/**
 * A ring of points in the core's memory, in units of the length: x, y, 1 − cos θ, three 32-bit numbers
 * a point. `points` has capacity + 1 of them, the last a copy of the first, so that segment i goes from
 * point i to point i + 1. The newest point, at `head`, is the bob itself; before it, going round,
 * lie `count` − 1 older ones. The segment from head to head + 1 and all that are not filled join nothing:
 * they are not drawn. The age of point i is (head − i) mod capacity.
 */
export interface Trace {
  readonly capacity: number;
  readonly head: number;
  readonly count: number;
  /** A view of the memory; taken anew with each call of the getter, since memory that grows loses its views. */
  readonly points: Float32Array;
  /** Point from which on, going round to `head`, points have changed with the last `follow`. */
  readonly changedFrom: number;
  /** s of the newest point. */
  readonly time: number;
  /** Goes on to a time, s, or begins anew where it lies elsewhere; false where the motion has ended before or is not yet there. */
  follow(time: number): boolean;
  /** Forgets all points: the next `follow` begins at its time. */
  restart(): void;
  free(): void;
}

export interface EllipseNow {
  readonly a: number;
  readonly b: number;
  readonly azimuth: number;
}

export interface TurningPoint extends EllipseNow {
  readonly time: number;
  readonly position: Vector;
}

export type Regime = "rest" | "balance" | "separatrix" | "plane" | "rotation" | "cone" | "ellipse" | "above";

export interface Summary {
  readonly regime: Regime;
  /** 1 counter-clockwise, −1 clockwise, 0 neither */
  readonly sense: number;
  /** ω, rad/s */
  readonly frequency: number;
  /** Ω, rad/s */
  readonly precession: number;
  /** 2π/ω, s; infinite on the separatrix */
  readonly swingPeriod: number;
  /** π/ω, s: from one highest point to the next */
  readonly radialPeriod: number;
  /** rad, signed: azimuth from one highest point to the next */
  readonly apsidalAngle: number;
  /** rad/s: of the outer turning points on the branch that turns least */
  readonly turning: number;
  readonly wholeTurns: boolean;
  /** s; infinite where nothing turns */
  readonly fullTurn: number;
  /** s; of the bob on a cone, infinite elsewhere */
  readonly onceRound: number;
  /** rad, from the downward vertical */
  readonly largestAngle: number;
  /** rad/s; null where (25) or (26) do not apply */
  readonly formula25: number | null;
  readonly frequency26: number | null;
  /** Approximate over exact, less 1; null where there is none */
  readonly error25: number | null;
  readonly periodError26: number | null;
  /** m: distance from the axis at the highest and at the lowest point */
  readonly outer: number;
  readonly inner: number;
  /** m above the lowest point of the sphere: of the highest and the lowest point */
  readonly high: number;
  readonly low: number;
  /** N: least and most */
  readonly tension: readonly [number, number];
  /** s; infinite if a thread never goes slack */
  readonly slackTime: number;
  /** The largest speed, m/s */
  readonly fastest: number;
}

export interface Settled {
  readonly length: number;
  /** m/s², of the place, and what moves the bob once its size and the air are counted */
  readonly gravity: number;
  readonly effectiveGravity: number;
  readonly mass: number;
  /** ω0, rad/s, and its period, s */
  readonly angularFrequency: number;
  readonly smallPeriod: number;
  /** √(g l), m/s: the scale of speeds */
  readonly speed: number;
  /** rad/s: what the Earth alone turns the plane by; and the time for a full turn, s */
  readonly earth: number;
  readonly earthTurn: number;
  /** Whether anything acts that the ideal pendulum does without */
  readonly acts: boolean;
  /** γ, 1/s; c, 1/m; δ, rad/s; Δγ, 1/s, as they act */
  readonly drag: { readonly linear: number; readonly quadratic: number };
  readonly anisotropy: number;
  readonly dampingAnisotropy: number;
  /** s: in which drag takes half of this launch's amplitude; infinite where there is none */
  readonly halfLife: number;
  /** The drive that would hold the amplitude and turn no narrow ellipse; null where nothing brakes. */
  readonly sustaining: { readonly push: number; readonly phase: number } | null;
}

export interface Measured {
  readonly frequency: number | null;
  readonly precession: number | null;
  readonly periodError: number | null;
  readonly precessionError: number | null;
}

/** Rates of the plane by their causes, rad/s, and their sum; a and b grow by so many m/s. */
export interface Shares {
  readonly earth: number;
  readonly intrinsic: number;
  readonly anisotropy: number;
  readonly damping: number;
  readonly drive: number;
  readonly total: number;
  readonly outer: number;
  readonly inner: number;
  readonly pace: "hurries" | "lags" | "stalls" | "as it should" | null;
}

export type Verdict = "round" | "to and fro" | "stands";

/** A place on the sphere of ellipses: u = 2ab/(a² + b²), φ = 2(ψ − χ) in rad. */
export interface Form {
  readonly circularity: number;
  readonly longitude: number;
}

export interface Orbit {
  readonly verdict: Verdict;
  /** least and largest circularity */
  readonly limits: readonly [number, number];
  readonly period: number;
  readonly rate: number;
  readonly slowest: number;
  readonly fastest: number;
  readonly azimuths: readonly [number, number];
}

export interface Portrait {
  /** Where the ellipse lies, and its orbit without drag and drive. */
  readonly form: Form;
  readonly orbit: Orbit;
  readonly axis: number;
  readonly equilibria: readonly (Form & { readonly stable: boolean })[];
  /** Where another ellipse of this size lies. */
  place(ellipse: EllipseNow): Form;
  /** `count` places along the orbit of a form, once round: circularity, longitude, and so on. */
  path(form: Form, count: number): Float64Array<ArrayBuffer>;
  /** For each form (circularity, longitude, …) what becomes of its plane if it is left free. */
  verdicts(forms: Float64Array): Verdict[];
}

export interface PlaneSettled {
  readonly verdict: Verdict;
  readonly from: number;
  readonly until: number;
  readonly turned: number;
  readonly azimuths: readonly [number, number];
  readonly widest: number;
  readonly amplitude: number;
  readonly dies: boolean;
}

export interface Seen {
  readonly name: string;
  readonly value: number;
  readonly unit: string;
}

/** What the core refuses: the kind's word, such as "too_strong", and the values that were seen. */
export class Refused extends Error {
  readonly kind: string;
  readonly seen: readonly Seen[];
  constructor(kind: string, seen: readonly Seen[]) {
    super(`${kind}: ${seen.map(({ name, value, unit }) => `${name} = ${value} ${unit}`.trimEnd()).join(", ")}`);
    this.name = "Refused";
    this.kind = kind;
    this.seen = seen;
  }
}
