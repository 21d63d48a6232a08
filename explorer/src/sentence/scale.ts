/** The scale of a ruler: logarithmic for what has no zero in sight, even for angles. */

import { unitFor, type Si } from "../numbers/ladders";
import type { Quantity } from "../state/quantities";

/** px that a factor of ten takes, and a radian. */
const DECADE = 330;
const RADIAN = 260;

type Ruled = Pick<Quantity, "si" | "least" | "most" | "value">;

const even = ({ si }: Pick<Quantity, "si">): boolean => si === "rad";

export function clamped({ least, most }: Ruled, value: number): number {
  return value < least ? least : value > most && Number.isFinite(value) ? most : value;
}

/** px from the lower end of the scale. */
export function place(quantity: Ruled, value: number): number {
  const inside = Math.min(Math.max(value, quantity.least), quantity.most);
  return even(quantity) ? RADIAN * (inside - quantity.least) : DECADE * Math.log10(inside / quantity.least);
}

/** The value so many px further on, to three digits. */
export function moved(quantity: Ruled, from: number, px: number): number {
  const start = Math.min(Math.max(from, quantity.least), quantity.most);
  const value = even(quantity) ? start + px / RADIAN : start * 10 ** (px / DECADE);
  if (even(quantity)) return Math.round((value * 1800) / Math.PI) * (Math.PI / 1800);
  return Number(value.toPrecision(3));
}

/** The distance of two marks at a value: a tenth of its power of ten, or a degree. */
function mark(quantity: Ruled, value: number): number {
  return even(quantity) ? Math.PI / 180 : 10 ** (Math.floor(Math.log10(Math.max(value, quantity.least)) + 1e-9) - 1);
}

/** What a key makes of the value: a mark with the arrows, a tenth with Shift, ten with Page up and down. */
export function stepped(quantity: Ruled, event: KeyboardEvent): number | null {
  const ways: Readonly<Record<string, number>> = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 };
  if (event.key === "Home") return quantity.least;
  if (event.key === "End") return quantity.most;
  const way = ways[event.key];
  if (way === undefined) return null;
  const value = Number.isFinite(quantity.value) ? Math.min(Math.max(quantity.value, quantity.least), quantity.most) : quantity.most;
  // Downwards from a power of ten the marks are those of the decade below.
  const size = mark(quantity, way < 0 && !even(quantity) ? value * (1 - 1e-9) : value);
  const next = value + way * size * (event.shiftKey ? 0.1 : 1);
  return Math.min(Math.max(Number(next.toPrecision(12)), quantity.least), quantity.most);
}

export interface Mark {
  readonly at: number;
  readonly value: number;
  /** 2 with a figure, 1 longer than others, 0 short */
  readonly rank: 0 | 1 | 2;
}

/** All marks within so many px of a value. */
export function marks(quantity: Ruled, middle: number, reach: number): Mark[] {
  const found: Mark[] = [];
  const here = place(quantity, middle);
  const add = (value: number, rank: 0 | 1 | 2): void => {
    const at = place(quantity, value) - here;
    if (value >= quantity.least * (1 - 1e-9) && value <= quantity.most * (1 + 1e-9) && Math.abs(at) <= reach) found.push({ at, value, rank });
  };
  if (even(quantity)) {
    for (let degree = 0; degree <= 180; degree++) add((degree * Math.PI) / 180, degree % 15 === 0 ? 2 : degree % 5 === 0 ? 1 : 0);
    return found;
  }
  const unit = quantity.si === "ratio" ? 1 : unitFor(middle, quantity.si as Si).size;
  const [low, high] = [-1, 1].map((way) => Math.floor(Math.log10(moved(quantity, middle, way * reach) / unit) + 1e-9)) as [number, number];
  for (let power = low; power <= high; power++)
    for (let tenth = 10; tenth < 100; tenth++) add(Number((unit * tenth * 10 ** (power - 1)).toPrecision(3)), [10, 20, 50].includes(tenth) ? 2 : tenth % 10 === 0 || tenth % 5 === 0 ? 1 : 0);
  return found;
}


/** From where to where, in px from a value, the scale has nothing more to offer; up to so many px on either side. */
export function ends(quantity: Ruled, middle: number, reach: number): readonly (readonly [from: number, to: number])[] {
  const here = place(quantity, middle);
  const [low, high] = [place(quantity, quantity.least) - here, place(quantity, quantity.most) - here];
  const found: [number, number][] = [];
  if (low > -reach) found.push([-reach, low]);
  if (high < reach) found.push([high, reach]);
  return found;
}

/** Where a hand has been, px, and when, ms. */
export interface Sample {
  readonly x: number;
  readonly time: number;
}

/** How long a scale that is let go glides on, how far back its speed is looked for, and how fast it is at least, ms and px/ms. */
const GLIDE = 200;
const RECENT = 80;
const SLOWEST = 0.1;

/** How a scale glides on: by how many px in all, and at a time after it was let go, ms. */
export interface Glide {
  readonly whole: number;
  at(time: number): { readonly px: number; readonly done: boolean };
}

/** The scale keeps the speed of the hand that lets it go, and loses it evenly. */
export function glide(way: readonly Sample[], end: number): Glide {
  const recent = way.filter(({ time }) => time >= end - RECENT);
  const [first, last] = [recent[0], recent.at(-1)];
  const speed = first && last && end > first.time ? (last.x - first.x) / (end - first.time) : 0;
  const whole = Math.abs(speed) < SLOWEST ? 0 : (speed * GLIDE) / 2;
  return {
    whole,
    at: (time) => {
      const share = Math.min(Math.max(time / GLIDE, 0), 1);
      return { px: whole * share * (2 - share), done: share === 1 };
    },
  };
}
