/** What a hand does to the bob: how far it pulls it aside, and how it pushes it across. */

import type { Core, Given, LaunchGiven, State, Vector } from "../core";

export interface Hand {
  /** m from the axis, and the angle from the downward vertical, rad */
  readonly pull: number;
  readonly angle: number;
  /** rad, of the place */
  readonly azimuth: number;
  /** m/s across, positive counter-clockwise seen from above, and the whole speed */
  readonly across: number;
  readonly speed: number;
  /** Whether the push is not square to the pull. */
  readonly oblique: boolean;
  readonly velocity: Vector;
  readonly position: Vector;
}

/** Beyond this angle, the place is said in degrees, since the distance from the axis falls again. */
export const HIGH = Math.PI / 2;

export function handOf({ position, velocity }: State): Hand {
  const [x, y, z] = position;
  const pull = Math.hypot(x, y);
  const speed = Math.hypot(...velocity);
  const across = pull > 0 ? (x * velocity[1] - y * velocity[0]) / pull : speed;
  const oblique = Math.abs(Math.abs(across) - speed) > 1e-3 * speed;
  return { pull, angle: Math.atan2(pull, z), azimuth: Math.atan2(y, x), across, speed, oblique, velocity, position };
}

/** The launch of a place and a velocity: seen from above where it is well below the support, else a state. */
export function launchAt(core: Core, length: number, position: Vector, velocity: Vector): LaunchGiven {
  const state = core.nearestState(length, position, velocity);
  const [x, y, z] = state.position;
  if (z > 0.3 * length) return { kind: "plane", x, y, vx: state.velocity[0], vy: state.velocity[1] };
  return state;
}

/** Beyond this share of the length a place is given by its angle, since the height is steep there. */
const STEEP = 0.95;

/** The same push from a place that is so far from the axis. */
export function pulled(core: Core, given: Given, hand: Hand, pull: number): Given {
  if (given.site) return { ...given, launch: swing(given, pull, hand.azimuth) };
  const share = pull / given.pendulum.length;
  const angle = Math.asin(Math.min(share, 1));
  if (hand.angle > HIGH || share > STEEP) return raised(core, given, hand, hand.angle > HIGH ? Math.PI - angle : angle);
  const [cos, sin] = [Math.cos(hand.azimuth), Math.sin(hand.azimuth)];
  const launch: LaunchGiven = { kind: "plane", x: pull * cos, y: pull * sin, vx: -hand.across * sin, vy: hand.across * cos };
  return { ...given, launch };
}

/** The same push from a place at that angle from the downward vertical. */
export function raised(core: Core, given: Given, hand: Hand, angle: number): Given {
  const { length } = given.pendulum;
  const [cos, sin] = [Math.cos(hand.azimuth), Math.sin(hand.azimuth)];
  const aside = length * Math.sin(angle);
  const place: Vector = [aside * cos, aside * sin, length * Math.cos(angle)];
  return { ...given, launch: launchAt(core, length, place, [-hand.across * sin, hand.across * cos, 0]) };
}

/** The same place with another push across. */
export function pushed(core: Core, given: Given, hand: Hand, across: number): Given {
  const [cos, sin] = [Math.cos(hand.azimuth), Math.sin(hand.azimuth)];
  return { ...given, launch: launchAt(core, given.pendulum.length, hand.position, [-across * sin, across * cos, 0]) };
}

/** A swing let go without a push, as with a burnt thread; circles stay circles. */
export function swing(given: Given, a: number, azimuth: number): LaunchGiven {
  const { launch } = given;
  if (launch.kind === "apsides" && launch.a === launch.b) return { kind: "apsides", a, b: a };
  return { kind: "ellipse", a, b: 0, ...(azimuth ? { azimuth } : {}) };
}
