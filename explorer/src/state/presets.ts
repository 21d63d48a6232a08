/** The twelve examples, with the keys of job files. */

import type { Given } from "../core";
import { DAY, DEGREE, HOUR } from "../numbers/ladders";
import type { PresetKey } from "../words/presets";

export interface Preset {
  readonly given: Given;
  /** s: how much of the motion the timeline shows at first */
  readonly duration: number;
  /** s: where it begins, so that something is drawn already */
  readonly start: number;
  /** Seconds of the pendulum in one of the page. */
  readonly speed: number;
  readonly deviation?: boolean;
}

const ideal = (launch: Given["launch"], length = 1): Given => ({ pendulum: { length }, launch });

export const PRESETS: Record<PresetKey, Preset> = {
  rosette: { given: ideal({ kind: "plane", x: 0.45, y: 0, vx: 0, vy: 0.5 }), duration: 40, start: 6, speed: 1 },
  small: { given: ideal({ kind: "ellipse", a: 0.1, b: 0.03 }), duration: 60, start: 4, speed: 1 },
  straight: {
    given: { pendulum: { length: 67, gravity: 9.8094 }, launch: { kind: "ellipse", a: 3, b: 0.01 } },
    duration: 300,
    start: 16,
    speed: 2,
  },
  cone: { given: ideal({ kind: "angles", theta: 40 * DEGREE, phi_rate: 213.2 * DEGREE }), duration: 20, start: 2, speed: 1 },
  over: { given: ideal({ kind: "plane", x: 0.1, y: 0, vx: 0, vy: 7.2 }), duration: 30, start: 2, speed: 0.5 },
  separatrix: { given: ideal({ kind: "angles", theta: 178 * DEGREE, phi_rate: 0.4 }), duration: 60, start: 3, speed: 1 },
  // examples/pantheon-day.toml
  pantheon: {
    given: {
      pendulum: { length: 67, mass: 28 },
      launch: { kind: "ellipse", a: 3, b: 0 },
      site: { latitude: 48.846 * DEGREE },
      drag: { half_life: 4 * HOUR },
      suspension: { anisotropy: 3.8e-6, axis: 30 * DEGREE },
      bob: { radius: 0.084, density: 11_300, thread_mass: 0.8 },
    },
    duration: DAY,
    start: 2 * HOUR,
    speed: HOUR,
  },
  southpole: {
    given: { pendulum: { length: 33 }, launch: { kind: "ellipse", a: 1, b: 0 }, site: { latitude: -90 * DEGREE, height: 2835 } },
    duration: DAY,
    start: 2 * HOUR,
    speed: HOUR,
  },
  equator: {
    given: { pendulum: { length: 20 }, launch: { kind: "ellipse", a: 1, b: 0 }, site: { latitude: 0 } },
    duration: DAY,
    start: 2 * HOUR,
    speed: HOUR,
  },
  // examples/short.toml
  short: {
    given: {
      pendulum: { length: 1 },
      launch: { kind: "ellipse", a: 0.1, b: 0 },
      site: { latitude: 48 * DEGREE },
      drag: { half_life: 1200 },
      suspension: { anisotropy: 9.4e-5, axis: 30 * DEGREE },
      bob: { diameter: 0.06, density: 8500 },
      drive: { push: 1.9e-4, radius: 0.03 },
    },
    duration: 6 * HOUR,
    start: 600,
    speed: 600,
  },
  bravais: {
    given: { pendulum: { length: 10 }, launch: { kind: "apsides", a: 0.5, b: 0.5 }, site: { latitude: 48.8 * DEGREE } },
    duration: 3 * HOUR,
    // Where they start the two bobs are one picture.
    start: 1,
    speed: 1,
  },
  // examples/guelph.toml
  guelph: {
    given: {
      pendulum: { length: 0.83, mass: 4.5 },
      launch: { kind: "ellipse", a: 0.03, b: 0 },
      site: { latitude: 43.53 * DEGREE },
      drag: { linear: 1e-3 },
      suspension: { anisotropy: 1.5e-4, axis: 17.2 * DEGREE, damping_anisotropy: 3e-6, damping_axis: 17.2 * DEGREE },
      drive: { push: 1.0395e-4, phase: 24.95 * DEGREE },
    },
    duration: 36 * HOUR,
    start: HOUR,
    speed: HOUR,
    deviation: true,
  },
};
