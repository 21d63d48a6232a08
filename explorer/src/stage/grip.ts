/** Taking hold of the bob: one way for pointer, touch and keys. */

import { batch, signal } from "@preact/signals";
import type { Core, Given, State, Vector } from "../core";
import { DEGREE } from "../numbers/ladders";
import { HIGH, launchAt, swing } from "../state/hand";
import { redraw } from "../state/loop";
import { clock, core, given, gripped, launch, live, mode, playing, preset, pulledOnce, ruling } from "../state/page";
import type { PresetKey } from "../words/presets";
import { camera, placeUnder } from "./sight";

/** What was before the grip, for Escape. */
interface Before {
  readonly given: Given;
  readonly preset: PresetKey | null;
  readonly time: number;
  readonly playing: boolean;
}

let before: Before | null = null;
/** m/s across, which a still release gives. */
let across = 0;

/** Counts own launches that were let go, for the address. */
export const released = signal(0);

/** A pull beyond the level of the support stops there for so much. */
const DETENT = 3 * DEGREE;

/** An arrow that reaches so far out, in units of the length, means that share of √(g l). */
const ARROW_OUT = 0.34;
const ARROW_PUSH = 0.16;

/** A flick is faster than this, px/s, over the last so many ms; it gives at most so many √(g l). */
const FLICK = 120;
const FLICK_TIME = 80;
const FASTEST = 2;

function engine(): Core | null {
  return typeof core.value === "string" ? null : core.value;
}

/** Takes hold where the bob is now. */
export function grip(): void {
  const now = live.value;
  if (!now || gripped.value || !engine()) return;
  before = { given: given.value, preset: preset.value, time: clock.time, playing: playing.value };
  const state = now.main.motion.state(clock.time) ?? (now.main.motion.state(0) as State);
  across = mode.value === "free" ? now.hand.across : 0;
  gripped.value = true;
  pulledOnce.value = true;
  playing.value = false;
  ruling.value = null;
  hold(state.position);
}

/** Holds the bob at a place, m, with the push that the arrow shows. */
export function hold(position: Vector, velocity?: Vector): boolean {
  const [now, one] = [live.value, engine()];
  if (!now || !one) return false;
  const [x, y] = position;
  const aside = Math.hypot(x, y);
  const [cos, sin] = aside > 0 ? [x / aside, y / aside] : [1, 0];
  const launched =
    mode.value === "free"
      ? launchAt(one, now.given.pendulum.length, position, velocity ?? [-across * sin, across * cos, 0])
      : swing(given.value, aside, Math.atan2(y, x));
  const done = launch({ ...given.value, launch: launched });
  if (done) preset.value = null;
  redraw();
  return done;
}

/** The place that a pixel of the stage means, m; what is drawn wider than it is goes back. */
export function placeAt(x: number, y: number): Vector | null {
  const [now, one] = [live.value, engine()];
  if (!now || !one) return null;
  const { length } = now.given.pendulum;
  const [px, py, pz] = placeUnder(one, x, y);
  const [near, far] = [px / now.stretch, py / now.stretch];
  if (now.stretch !== 1 || mode.value !== "free") {
    const share = Math.min(1, 0.5 / Math.hypot(near, far));
    const [sx, sy] = [near * share, far * share];
    return [sx * length, sy * length, length * Math.sqrt(1 - sx * sx - sy * sy)];
  }
  const angle = Math.atan2(Math.hypot(px, py), pz);
  if (angle > HIGH && angle < HIGH + DETENT) {
    const aside = Math.hypot(px, py);
    return [(px / aside) * length, (py / aside) * length, 0];
  }
  return [px * length, py * length, pz * length];
}

/** The tip of the arrow, in space, and what a pixel along it means, m/s. */
export function arrow(): { readonly from: readonly [number, number]; readonly tip: readonly [number, number]; readonly perPixel: number } | null {
  const now = live.value;
  if (!now || mode.value !== "free") return null;
  const { length } = now.given.pendulum;
  const [x, y, z] = now.hand.position.map((one) => one / length) as [number, number, number];
  const aside = Math.hypot(x, y);
  const [cos, sin] = aside > 0 ? [x / aside, y / aside] : [1, 0];
  const [wide, far] = [now.stretch * x, now.stretch * y];
  const height = now.stretch === 1 ? -z : -Math.sqrt(Math.max(0, 1 - wide * wide - far * far));
  const out = (ARROW_OUT / ARROW_PUSH) * (now.hand.across / now.settled.speed) * now.stretch;
  const shown = Math.max(-0.8, Math.min(0.8, Math.abs(out) < 0.16 ? (out < 0 ? -0.16 : 0.16) : out));
  const at = camera.project([wide, far, height]);
  const unit = camera.project([wide - 0.16 * sin, far + 0.16 * cos, height]);
  const tip = camera.project([wide - shown * sin, far + shown * cos, height]);
  const pixels = Math.hypot(unit.x - at.x, unit.y - at.y) / 0.16;
  return { from: [at.x, at.y], tip: [tip.x, tip.y], perPixel: (ARROW_PUSH * now.settled.speed) / (ARROW_OUT * now.stretch * Math.max(pixels, 1)) };
}

/** Sets the push across, m/s; the bob stays where it is held. */
export function pushAcross(value: number): void {
  const now = live.value;
  if (!now) return;
  if (!gripped.value) grip();
  const most = FASTEST * now.settled.speed;
  across = Math.min(Math.max(value, -most), most);
  hold((live.value ?? now).hand.position);
}

/** Moves the held bob outwards by so much, m. */
export function pullOut(by: number): void {
  const now = live.value;
  if (!now) return;
  if (!gripped.value) grip();
  const { length } = now.given.pendulum;
  const { azimuth, angle } = (live.value ?? now).hand;
  const next = Math.min(Math.max(angle + by / length, 1e-3), mode.value === "free" ? Math.PI - 1e-3 : 0.5);
  const aside = length * Math.sin(next);
  hold([aside * Math.cos(azimuth), aside * Math.sin(azimuth), length * Math.cos(next)]);
}

interface Sample {
  readonly time: number;
  readonly x: number;
  readonly y: number;
  readonly place: Vector;
}

const samples: Sample[] = [];

/** A pointer that holds the bob has moved: on its way through these pixels, the last of which is where it is. */
export function moveThrough(way: readonly { readonly x: number; readonly y: number; readonly time: number }[]): void {
  for (const one of way) {
    const place = placeAt(one.x, one.y);
    if (place) samples.push({ ...one, place });
  }
  const last = samples.at(-1);
  if (!last) return;
  while ((samples[0]?.time ?? last.time) < last.time - FLICK_TIME) samples.shift();
  hold(last.place);
}

/** Lets go: the motion begins. */
export function release(time?: number): void {
  if (!gripped.value) return;
  const flick = time === undefined ? null : flicked(time);
  if (flick) hold(flick.place, flick.velocity);
  samples.length = 0;
  before = null;
  batch(() => {
    gripped.value = false;
    // Once more, now drawn as large as suits it.
    launch(given.value);
    playing.value = true;
    released.value++;
  });
  redraw();
}

function flicked(time: number): { place: Vector; velocity: Vector } | null {
  const now = live.value;
  const recent = samples.filter((one) => one.time >= time - FLICK_TIME);
  const [first, last] = [recent[0], recent.at(-1)];
  if (!now || !first || !last || last.time - first.time < 8 || mode.value !== "free") return null;
  const passed = (last.time - first.time) / 1000;
  if (Math.hypot(last.x - first.x, last.y - first.y) / passed < FLICK) return null;
  const way = last.place.map((one, index) => (one - (first.place[index] ?? 0)) / passed) as [number, number, number];
  const share = Math.min(1, (FASTEST * now.settled.speed) / Math.hypot(...way));
  return { place: last.place, velocity: [way[0] * share, way[1] * share, way[2] * share] };
}

/** All is again as it was before the grip. */
export function cancel(): void {
  if (!gripped.value || !before) return;
  gripped.value = false;
  launch(before.given, before.time);
  preset.value = before.preset;
  playing.value = before.playing;
  samples.length = 0;
  before = null;
  redraw();
}
