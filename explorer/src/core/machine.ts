/** The module of WebAssembly as it is: its functions, its memory, and the exchange through which numbers go. */
import { Refused, type Seen } from "./core";

/** The place of a motion or a trace in memory; 0 for none. */
export type Handle = number;

/** What crates/kugelpendel-wasm exports; its functions say there what they take and tell. */
interface Exports {
  readonly memory: WebAssembly.Memory;
  allocate(count: number): number;
  release(place: number, count: number): void;
  exchange(): number;
  refusal_kind(index: number): number;
  settled(): number;
  summary(): number;
  measured(law: number): number;
  nearest_place(): void;
  nearest_launch(): void;
  motion_new(law: number): Handle;
  motion_free(motion: Handle): void;
  motion_state(motion: Handle, time: number): number;
  motion_ended(motion: Handle): number;
  motion_positions(motion: Handle, times: number, count: number, out: number): void;
  motion_drawn(motion: Handle, start: number, step: number, count: number, out: number): void;
  motion_azimuths(motion: Handle, times: number, count: number, out: number): void;
  motion_ellipses(motion: Handle, times: number, count: number, out: number): void;
  motion_distances(motion: Handle, other: Handle, times: number, count: number, out: number): void;
  motion_turning_points(motion: Handle, from: number, to: number, most: number, out: number): number;
  trace_new(spacing: number, capacity: number): Handle;
  trace_free(trace: Handle): void;
  trace_points(trace: Handle): number;
  trace_restart(trace: Handle): void;
  trace_follow(trace: Handle, motion: Handle, time: number): number;
  trace_head(trace: Handle): number;
  trace_count(trace: Handle): number;
  trace_changed(trace: Handle): number;
  shares(motion: Handle, time: number): number;
  portrait(a: number, b: number, azimuth: number): number;
  portrait_form(axis: number, a: number, b: number, azimuth: number): void;
  portrait_path(
    rotation: number, anisotropy: number, axis: number, intrinsic: number,
    circularity: number, longitude: number, count: number, out: number,
  ): void;
  portrait_verdicts(
    rotation: number, anisotropy: number, axis: number, intrinsic: number,
    forms: number, count: number, out: number,
  ): void;
  settles(): number;
}

/** How a request has gone: all done, ended before, or to be asked again. */
export const DONE = 0;
export const UNFINISHED = 2;

export class Machine {
  readonly call: Exports;
  private readonly place: number;
  private slots = new Float64Array(0);

  constructor(instance: WebAssembly.Instance) {
    this.call = instance.exports as unknown as Exports;
    this.place = this.call.exchange();
  }

  /** The exchange; memory that has grown has lost its views, so it is looked up with each call. */
  get told(): Float64Array {
    if (this.slots.buffer !== this.call.memory.buffer) {
      this.slots = new Float64Array(this.call.memory.buffer, this.place, 96);
    }
    return this.slots;
  }

  /** One of the numbers that the latest call has told. */
  at(slot: number): number {
    return this.told[slot] ?? Number.NaN;
  }

  vector(slot: number): readonly [number, number, number] {
    return [this.at(slot), this.at(slot + 1), this.at(slot + 2)];
  }

  put(numbers: readonly number[]): void {
    this.told.set(numbers);
  }

  /** Puts numbers in, calls, and takes a copy of those that come out. */
  through(input: ArrayLike<number>, outputs: number, call: (input: number, output: number) => void): Float64Array<ArrayBuffer> {
    const { allocate, release, memory } = this.call;
    const size = input.length + outputs;
    const place = allocate(size);
    const output = place + 8 * input.length;
    new Float64Array(memory.buffer, place, input.length).set(input);
    call(place, output);
    const found = new Float64Array(memory.buffer, output, outputs).slice();
    release(place, size);
    return found;
  }

  /** What the core has refused, as it has just told. */
  refusal(): Refused {
    const kind = this.text(0);
    const seen: Seen[] = [];
    for (let index = 0; index < this.at(2); index++) {
      const slot = 3 + 5 * index;
      seen.push({ name: this.text(slot), value: this.at(slot + 2), unit: this.text(slot + 3) });
    }
    return new Refused(kind, seen);
  }

  /** The words of all kinds of refusals. */
  refusalKinds(): string[] {
    const found: string[] = [];
    while (this.call.refusal_kind(found.length) === 1) found.push(this.text(0));
    return found;
  }

  private text(slot: number): string {
    return new TextDecoder().decode(new Uint8Array(this.call.memory.buffer, this.at(slot), this.at(slot + 1)));
  }
}
