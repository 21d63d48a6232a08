/** What is drawn of the pendulum in space, the same for both ways of drawing it. */

import type { Camera, Point } from "./camera";
import type { Ink } from "./ink";

/** A way through space. Its points are x, y, 1 − cos θ in units of the length. */
export interface Strand {
  /** The same name keeps the same memory on the graphics processor. */
  readonly name: string;
  readonly points: Float32Array;
  /** Of a ring of points: where its newest one is, how many there are and from where on they are new. */
  readonly ring: { readonly head: number; readonly count: number; readonly changedFrom: number; readonly capacity: number } | null;
  /** How many of the points are to be drawn where it is no ring. */
  readonly count: number;
  readonly color: string;
  readonly width: number;
  readonly dash: readonly number[];
  /** Opacity of the newest and of the oldest point. */
  readonly alpha: readonly [newest: number, oldest: number];
  /** So many times as far from the axis as it is, kept on the sphere. */
  readonly stretch: number;
  /** Whether it is drawn on the floor below. */
  readonly onFloor: boolean;
}

export interface Bob {
  readonly at: Point;
  /** In units of the length. */
  readonly radius: number;
  /** Brass, or a ring of this colour. */
  readonly ring: string | null;
  readonly alpha: number;
}

export interface Scene {
  readonly camera: Camera;
  readonly ink: Ink;
  readonly floorRadius: number;
  readonly strands: readonly Strand[];
  readonly threads: readonly Point[];
  /** Whether what holds the bob is a rod. */
  readonly rod: boolean;
  readonly bobs: readonly Bob[];
}

export interface SceneRenderer {
  resize(width: number, height: number, density: number): void;
  draw(scene: Scene): void;
  dispose(): void;
}

/** Steps in which a trace fades, from its newest to its oldest point. */
export const FADE_STEPS = 36;

/** Radius of the bob in units of the length. */
export const BOB_RADIUS = 0.062;

/** Where a point of a strand lies in space. */
export function placed(x: number, y: number, height: number, stretch: number): Point {
  if (stretch === 1) return [x, y, height - 1];
  const [wide, far] = [stretch * x, stretch * y];
  return [wide, far, -Math.sqrt(Math.max(0, 1 - wide * wide - far * far))];
}
