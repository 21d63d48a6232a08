/** The quantities of the sentence: what a ruler may set each of them to. */

import type { Given } from "../core";
import { DEGREE, HOUR, MINUTE, type Si } from "../numbers/ladders";
import { asGiven, degrees, oneIn, quantity, type Language } from "../numbers/spell";
import type { Words } from "../words/en";
import { HIGH, pulled, pushed, raised } from "./hand";
import type { Live } from "./live";
import { core, given, live, relaunch } from "./page";

export interface Chip {
  readonly text: string;
  readonly value: number;
}

export interface Quantity {
  readonly key: "length" | "gravity" | "pull" | "push" | "halfLife" | "clamp";
  readonly label: string;
  readonly si: Si | "ratio";
  readonly value: number;
  readonly least: number;
  readonly most: number;
  readonly chips: readonly Chip[];
  readonly spell: (value: number) => string;
  /** False where the core refuses it. */
  readonly set: (value: number) => boolean;
}

export const BODIES = { moon: 1.62, mars: 3.71, earth: 9.80665, jupiter: 24.79 } as const;
export type Body = keyof typeof BODIES;

/** The body whose gravity this is; standard gravity, and any of the Earth's places, is the Earth's. */
export function bodyOf(gravity: number): Body | null {
  if (gravity > 9.76 && gravity < 9.84) return "earth";
  return (Object.keys(BODIES) as Body[]).find((one) => Math.abs(BODIES[one] - gravity) < 1e-9) ?? null;
}

/** In days and metres a quantity is said as it was given; where a swing is looked at, to three digits. */
function said(value: number, si: Si, now: Live, language: Language): string {
  return now.mode === "free" ? quantity(value, si, 3, language) : asGiven(value, si, language, 3);
}

type Maker = (now: Live, words: Words, language: Language) => Quantity;

const chip = (value: number, si: Si, language: Language): Chip => ({ text: asGiven(value, si, language), value });

function withPendulum(change: Partial<Given["pendulum"]>): Given {
  return { ...given.value, pendulum: { ...given.value.pendulum, ...change } };
}

const length: Maker = (now, words, language) => ({
  key: "length",
  label: words.ruler.length,
  si: "m",
  value: now.given.pendulum.length,
  least: Math.max(0.02, now.hand.pull * 1.02),
  most: 1000,
  chips: [chip(0.25, "m", language), chip(1, "m", language), { text: words.ruler.foucault, value: 67 }],
  spell: (value) => said(value, "m", now, language),
  set: (value) => relaunch(stretched(now, value)),
});

/** Another length under the same place, seen from above, and the same push. */
function stretched(now: Live, to: number): Given {
  const next = withPendulum({ length: to });
  const engine = core.value;
  if (next.site || typeof engine === "string") return next;
  if (now.hand.angle > HIGH) return raised(engine, next, now.hand, now.hand.angle);
  return pulled(engine, next, now.hand, now.hand.pull);
}

const gravity: Maker = (now, words, language) => ({
  key: "gravity",
  label: words.ruler.gravity,
  si: "m/s²",
  value: now.settled.gravity,
  least: 0.1,
  most: 100,
  chips: (Object.keys(BODIES) as Body[]).map((one) => ({ text: words.bodies[one], value: BODIES[one] })),
  spell: (value) => quantity(value, "m/s²", 3, language),
  set: (value) => relaunch(samePush(now, withPendulum({ gravity: value }))),
});

/** A launch that was said by its ellipse keeps its place and its push. */
function samePush(now: Live, next: Given): Given {
  const engine = core.value;
  return next.launch.kind === "ellipse" && typeof engine !== "string" ? pushed(engine, next, now.hand, now.hand.across) : next;
}

const pull: Maker = (now, words, language) => {
  const high = now.hand.angle > HIGH;
  const { length: whole } = now.given.pendulum;
  const set = (value: number): boolean => {
    const engine = core.value;
    if (typeof engine === "string") return false;
    return relaunch(high ? raised(engine, given.value, now.hand, value) : pulled(engine, given.value, now.hand, value));
  };
  if (high)
    return {
      key: "pull",
      label: words.ruler.pull,
      si: "rad",
      value: now.hand.angle,
      least: 5 * DEGREE,
      most: 179.9 * DEGREE,
      chips: [45, 90, 178].map((one) => ({ text: degrees(one * DEGREE, 0, language), value: one * DEGREE })),
      spell: (value) => degrees(value, 1, language),
      set,
    };
  const chips = [0.05, 0.2, 0.45].map((share) => chip(Number((share * whole).toPrecision(2)), "m", language));
  return {
    key: "pull",
    label: words.ruler.pull,
    si: "m",
    value: now.hand.pull,
    least: 1e-4 * whole,
    most: (given.value.site ? 0.5 : 0.999) * whole,
    chips: given.value.site ? chips : [...chips, { text: words.ruler.upside, value: UPSIDE }],
    spell: (value) => said(value, "m", now, language),
    set: (value) => (value === UPSIDE ? upside(now) : set(value)),
  };
};

/** Not a distance: the chip that puts the bob nearly on top. */
const UPSIDE = -1;

function upside(now: Live): boolean {
  const engine = core.value;
  return typeof engine !== "string" && relaunch(raised(engine, given.value, now.hand, 178 * DEGREE));
}

const push: Maker = (now, words, language) => {
  const { across, oblique, speed } = now.hand;
  const size = oblique ? speed : Math.abs(across);
  const sense = across < 0 ? -1 : 1;
  const set = (value: number): boolean => {
    const engine = core.value;
    return typeof engine !== "string" && relaunch(pushed(engine, given.value, now.hand, value));
  };
  return {
    key: "push",
    label: words.ruler.push,
    si: "m/s",
    value: size,
    least: 1e-4 * now.settled.speed,
    most: 10 * now.settled.speed,
    chips: [
      { text: words.ruler.still, value: 0 },
      ...[0.1, 0.5].map((one) => chip(Number((one * now.settled.speed).toPrecision(1)), "m/s", language)),
      { text: words.ruler.reverse, value: -size },
    ],
    spell: (value) => quantity(Math.abs(value), "m/s", 3, language),
    set: (value) => set(value < 0 ? sense * value : sense * value),
  };
};

const halfLife: Maker = (now, words, language) => ({
  key: "halfLife",
  label: words.ruler.halfLife,
  si: "s",
  value: now.settled.halfLife,
  least: 10,
  most: 1e6,
  chips: [
    { text: words.ruler.never, value: Number.POSITIVE_INFINITY },
    chip(20 * MINUTE, "s", language),
    chip(HOUR, "s", language),
    chip(4 * HOUR, "s", language),
  ],
  spell: (value) => (Number.isFinite(value) ? said(value, "s", now, language) : words.given.nothing),
  set: (value) => relaunch(braked(value)),
});

function braked(value: number): Given {
  const { drag, drive, ...rest } = given.value;
  if (Number.isFinite(value)) return { ...rest, ...(drive && { drive }), drag: { half_life: value } };
  // Without a brake a drive would lift the bob for ever.
  return { ...rest, ...(drag?.quadratic ? { drag: { quadratic: drag.quadratic } } : {}) };
}

const clamp: Maker = (now, words, language) => ({
  key: "clamp",
  label: words.ruler.clamp,
  si: "ratio",
  value: Math.abs(now.settled.anisotropy) / now.settled.angularFrequency,
  least: 1e-8,
  most: 1e-2,
  chips: [{ text: words.ruler.even, value: 0 }, ...[1e-6, 1e-5, 1e-4].map((value) => ({ text: oneIn(value, language), value }))],
  spell: (value) => (value > 0 ? oneIn(value, language) : words.given.even),
  set: (value) => relaunch(clamped(now, value)),
});

function clamped(now: Live, ratio: number): Given {
  const { suspension, ...rest } = given.value;
  if (ratio === 0) return rest;
  const { period_along: _along, period_across: _across, ...kept } = suspension ?? { axis: 30 * DEGREE };
  return { ...rest, suspension: { ...kept, anisotropy: ratio * now.settled.angularFrequency } };
}

const MAKERS = { length, gravity, pull, push, halfLife, clamp } as const;
export type QuantityKey = keyof typeof MAKERS;

export function quantityOf(key: QuantityKey, words: Words, language: Language): Quantity | null {
  const now = live.value;
  return now ? MAKERS[key](now, words, language) : null;
}
