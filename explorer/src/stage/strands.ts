/** The strands and bobs of this moment, the same for the stage and for the plan. */

import type { EllipseNow, State } from "../core";
import type { Ink } from "../drawing/ink";
import { BOB_RADIUS, placed, type Bob, type Strand } from "../drawing/scene";
import { STROKES, type Drawn } from "../drawing/strokes";
import { launches } from "../state/page";
import { RUNGS, type Live, type Moving } from "../state/live";

export interface Seen {
  readonly strands: readonly Strand[];
  readonly bobs: readonly Bob[];
  /** x and y in units of the length of each bob, for the plan. */
  readonly places: readonly { readonly x: number; readonly y: number; readonly ring: string | null }[];
}

function ring({ trace }: Moving): NonNullable<Strand["ring"]> {
  const { head, count, changedFrom, capacity } = trace;
  return { head, count, changedFrom, capacity };
}

function strand(name: string, moving: Moving, drawn: Drawn, ink: Ink, stretch: number, onFloor: boolean): Strand {
  const stroke = STROKES[drawn];
  return {
    // Each launch has memory of its own, which may lie where another's did.
    name: `${name} ${launches.value}`,
    points: moving.trace.points,
    ring: ring(moving),
    count: moving.trace.count,
    color: onFloor ? ink.color.ink : ink.color[stroke.ink],
    width: (onFloor ? 1.2 : stroke.width) * ink.weight,
    dash: [],
    alpha: onFloor ? [0.17, 0.17 * ink.oldest] : [1, ink.oldest],
    stretch,
    onFloor,
  };
}

/** Chronological copies of the short tails of the formulas, whose dashes go with the bob. */
const tails = new Map<string, Float32Array>();

function tail(name: string, moving: Moving, drawn: Drawn, ink: Ink, stretch: number): Strand {
  const { points, head, count, capacity } = moving.trace;
  let copy = tails.get(name);
  if (!copy || copy.length !== 3 * capacity) tails.set(name, (copy = new Float32Array(3 * capacity)));
  for (let index = 0; index < count; index++) {
    const from = 3 * ((head - count + 1 + index + capacity) % capacity);
    copy.set([points[from] ?? 0, points[from + 1] ?? 0, points[from + 2] ?? 0], 3 * index);
  }
  const stroke = STROKES[drawn];
  const color = ink.color[stroke.ink];
  return { name, points: copy, ring: null, count, color, width: stroke.width * ink.weight, dash: stroke.dash, alpha: [1, 1], stretch, onFloor: false };
}

function at({ trace }: Moving): readonly [number, number, number] {
  const base = 3 * trace.head;
  return [trace.points[base] ?? 0, trace.points[base + 1] ?? 0, trace.points[base + 2] ?? 0];
}

/** The motion with its trace, and the formulas beside it. */
export function moving(live: Live, beside: ReadonlySet<string>, ink: Ink): Seen {
  const { stretch } = live;
  const strands: Strand[] = [];
  const bobs: Bob[] = [];
  const places: { x: number; y: number; ring: string | null }[] = [];
  const mains = live.twin ? [live.main, live.twin] : [live.main];
  mains.forEach((one, index) => strands.push(strand(`floor ${index}`, one, "exact", ink, stretch, true)));
  mains.forEach((one, index) => strands.push(strand(`main ${index}`, one, "exact", ink, stretch, false)));
  for (const rung of RUNGS) {
    const one = live.rungs.get(rung);
    if (!one || !beside.has(rung) || one.trace.count === 0) continue;
    strands.push(tail(rung, one, rung, ink, stretch));
    const [x, y, height] = at(one);
    const color = ink.color[STROKES[rung].ink];
    bobs.push({ at: placed(x, y, height, stretch), radius: BOB_RADIUS, ring: color, alpha: 1 });
    places.push({ x, y, ring: color });
  }
  for (const one of mains) {
    if (one.trace.count === 0) continue;
    const [x, y, height] = at(one);
    bobs.push({ at: placed(x, y, height, stretch), radius: BOB_RADIUS, ring: null, alpha: 1 });
    places.push({ x, y, ring: null });
  }
  return { strands, bobs, places };
}

/** The bob where a hand holds it, without a trace. */
export function held(live: Live, state: State): Seen {
  const { length } = live.given.pendulum;
  const [x, y] = [state.position[0] / length, state.position[1] / length];
  const spot = placed(x, y, state.height, live.stretch);
  return { strands: [], bobs: [{ at: spot, radius: BOB_RADIUS, ring: null, alpha: 1 }], places: [{ x, y, ring: null }] };
}

/** How an ellipse of the average is enlarged on the stage: its length and its width, each by so much. */
export interface Enlarged {
  readonly long: number;
  readonly wide: number;
}

const AVERAGE = 0.4;
const WIDTH = 0.07;

/** Factors that make an ellipse fill its stage; its width at most a hundredfold of what its length gets. */
export function enlargement(a: number, widest: number, length: number): Enlarged {
  const long = round((AVERAGE * length) / a);
  const room = widest > 0 ? (WIDTH * length) / widest : long;
  return { long, wide: round(Math.min(Math.max(room, long), 100)) };
}

function round(factor: number): number {
  return factor < 1 ? 1 : Number(factor.toPrecision(factor < 10 ? 1 : 2));
}

const ELLIPSE_POINTS = 97;

/** The ellipse of the average as a strand, on the sphere or on the floor. */
export function ellipseStrand(name: string, ellipse: EllipseNow, length: number, by: Enlarged, look: Pick<Strand, "color" | "width" | "alpha" | "onFloor">): Strand {
  let points = tails.get(name);
  if (!points) tails.set(name, (points = new Float32Array(3 * ELLIPSE_POINTS)));
  const [cos, sin] = [Math.cos(ellipse.azimuth), Math.sin(ellipse.azimuth)];
  for (let index = 0; index < ELLIPSE_POINTS; index++) {
    const angle = (index / (ELLIPSE_POINTS - 1)) * 2 * Math.PI;
    const u = ((by.long * ellipse.a) / length) * Math.cos(angle);
    const v = ((by.wide * ellipse.b) / length) * Math.sin(angle);
    const [x, y] = [cos * u - sin * v, sin * u + cos * v];
    points.set([x, y, 1 - Math.sqrt(Math.max(0, 1 - x * x - y * y))], 3 * index);
  }
  return { name, points, ring: null, count: ELLIPSE_POINTS, dash: [], stretch: 1, ...look };
}
