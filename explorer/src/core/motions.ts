/** Motions and their traces, which live in the core's memory. */
import type { EllipseNow, Ending, Law, Motion, Shares, State, Trace, TurningPoint } from "./core";
import { DONE, UNFINISHED, type Handle, type Machine } from "./machine";

/** The laws by their numbers. */
export const LAWS: readonly Law[] = ["exact", "linear", "ellipse", "cubic", "averaged", "real", "rod"];

const ENDINGS: readonly Ending[] = ["slack", "level", "runaway"];
const PACES = ["hurries", "lags", "stalls", "as it should"] as const;

/** Numbers of a turning point. */
const TURNING = 7;

export class CoreMotion implements Motion {
  readonly law: Law;
  readonly handle: Handle;
  private readonly machine: Machine;

  /** The core has just been given what moves. */
  constructor(machine: Machine, law: Law) {
    this.machine = machine;
    this.law = law;
    this.handle = machine.call.motion_new(LAWS.indexOf(law));
    if (this.handle === 0) throw machine.refusal();
  }

  reach(time: number): boolean {
    return this.machine.call.motion_state(this.handle, time) !== UNFINISHED;
  }

  state(time: number): State | null {
    const { machine } = this;
    let outcome: number;
    do outcome = machine.call.motion_state(this.handle, time);
    while (outcome === UNFINISHED);
    if (outcome !== DONE) return null;
    return { position: machine.vector(0), velocity: machine.vector(3), height: machine.at(6), tension: machine.at(7) };
  }

  positions(times: Float64Array): Float64Array<ArrayBuffer> {
    const ask = (input: number, output: number) =>
      this.machine.call.motion_positions(this.handle, input, times.length, output);
    return this.machine.through(times, 3 * times.length, ask);
  }

  drawn(start: number, step: number, count: number): Float32Array<ArrayBuffer> {
    const { allocate, release, memory, motion_drawn } = this.machine.call;
    const room = Math.ceil((3 * count) / 2);
    const place = allocate(room);
    motion_drawn(this.handle, start, step, count, place);
    const found = new Float32Array(memory.buffer, place, 3 * count).slice();
    release(place, room);
    return found;
  }

  azimuths(times: Float64Array): Float64Array<ArrayBuffer> {
    const ask = (input: number, output: number) =>
      this.machine.call.motion_azimuths(this.handle, input, times.length, output);
    return this.machine.through(times, times.length, ask);
  }

  ellipses(times: Float64Array): Float64Array<ArrayBuffer> {
    const ask = (input: number, output: number) =>
      this.machine.call.motion_ellipses(this.handle, input, times.length, output);
    return this.machine.through(times, 3 * times.length, ask);
  }

  distances(other: Motion, times: Float64Array): Float64Array<ArrayBuffer> {
    if (!(other instanceof CoreMotion) || other === this) return new Float64Array(times.length);
    const ask = (input: number, output: number) =>
      this.machine.call.motion_distances(this.handle, other.handle, input, times.length, output);
    return this.machine.through(times, times.length, ask);
  }

  ellipse(time: number): EllipseNow | null {
    const [a, b, azimuth] = this.ellipses(Float64Array.of(time)) as unknown as [number, number, number];
    return Number.isFinite(a) ? { a, b, azimuth } : null;
  }

  turningPoints(from: number, to: number, most: number): TurningPoint[] {
    let count = 0;
    const rows = this.machine.through([], TURNING * most, (_, output) => {
      count = this.machine.call.motion_turning_points(this.handle, from, to, most, output);
    });
    return Array.from({ length: count }, (_, index) => {
      const row = rows.subarray(TURNING * index, TURNING * (index + 1));
      const [time, x, y, z, a, b, azimuth] = row as unknown as [number, number, number, number, number, number, number];
      return { time, position: [x, y, z], a, b, azimuth };
    });
  }

  shares(time: number): Shares | null {
    const { machine } = this;
    if (machine.call.shares(this.handle, time) === 0) return null;
    const [earth, intrinsic, anisotropy, damping, drive, total, outer, inner, pace] =
      machine.told as unknown as [number, number, number, number, number, number, number, number, number];
    return { earth, intrinsic, anisotropy, damping, drive, total, outer, inner, pace: PACES[pace] ?? null };
  }

  get ended(): { readonly time: number; readonly why: Ending } | null {
    if (this.machine.call.motion_ended(this.handle) === 0) return null;
    return { time: this.machine.at(0), why: ENDINGS[this.machine.at(1)] ?? "runaway" };
  }

  trace(spacing: number, capacity: number): Trace {
    return new CoreTrace(this.machine, this, spacing, capacity);
  }

  free(): void {
    this.machine.call.motion_free(this.handle);
  }
}

class CoreTrace implements Trace {
  readonly capacity: number;
  time = Number.NaN;
  private readonly machine: Machine;
  private readonly motion: CoreMotion;
  private readonly handle: Handle;
  private readonly place: number;
  private view = new Float32Array(0);

  constructor(machine: Machine, motion: CoreMotion, spacing: number, capacity: number) {
    this.machine = machine;
    this.motion = motion;
    this.capacity = capacity;
    this.handle = machine.call.trace_new(spacing, capacity);
    if (this.handle === 0) throw new RangeError(`A trace of ${capacity} points ${spacing} s apart cannot be kept.`);
    this.place = machine.call.trace_points(this.handle);
  }

  get points(): Float32Array {
    const { buffer } = this.machine.call.memory;
    if (this.view.buffer !== buffer) this.view = new Float32Array(buffer, this.place, 3 * (this.capacity + 1));
    return this.view;
  }

  get head(): number {
    return this.machine.call.trace_head(this.handle);
  }

  get count(): number {
    return this.machine.call.trace_count(this.handle);
  }

  get changedFrom(): number {
    return this.machine.call.trace_changed(this.handle);
  }

  follow(time: number): boolean {
    const done = this.machine.call.trace_follow(this.handle, this.motion.handle, time) === DONE;
    if (done) this.time = time;
    return done;
  }

  restart(): void {
    this.machine.call.trace_restart(this.handle);
  }

  free(): void {
    this.machine.call.trace_free(this.handle);
  }
}
