/** Camera and ink of the stage, kept for those who draw and for those who grip. */

import { Camera, ELEVATION, type Point } from "../drawing/camera";
import type { Core, Vector } from "../core";
import { DEGREE } from "../numbers/ladders";

export const camera = new Camera();

/** From where each mode is seen. */
const HOME = { free: -35 * DEGREE, foucault: -114 * DEGREE } as const;

/** How far from home a hand may turn the view. */
const MOST_TURN = 60 * DEGREE;

let home: number = HOME.free;

export function goHome(mode: "free" | "foucault"): void {
  home = HOME[mode];
  camera.azimuth = home;
  camera.elevation = ELEVATION;
}

export function turn(by: number, up: number): void {
  camera.azimuth = Math.min(Math.max(camera.azimuth + by, home - MOST_TURN), home + MOST_TURN);
  camera.elevation = Math.min(Math.max(camera.elevation + up, 8 * DEGREE), 50 * DEGREE);
}

/** The place on the unit sphere under a pixel of the stage, z down as the core has it. */
export function placeUnder(core: Core, x: number, y: number): Vector {
  const { eye, direction } = camera.ray(x, y);
  return core.nearestPlace(1, down(eye), down(direction));
}

export function down([x, y, z]: Point): Vector {
  return [x, y, -z];
}

