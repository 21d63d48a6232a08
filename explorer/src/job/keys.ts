/** The keys of job files that the page understands, and the units in which they are written for people. */

export type Kind =
  | "length" | "time" | "mass" | "acceleration" | "speed" | "angle" | "rate" | "density" | "decay" | "quadratic" | "number";

export type Holds = Kind | "vector of length" | "vector of speed" | "truth";

/** Tables, their keys, and what these hold; `launch` has its keys by kind. */
export const TABLES = {
  pendulum: { length: "length", gravity: "acceleration", mass: "mass" },
  site: { latitude: "angle", gravity: "acceleration", height: "length" },
  drag: {
    linear: "decay", quality: "number", half_life: "time", from_bob: "truth", thread_diameter: "length",
    quadratic: "quadratic",
  },
  suspension: {
    anisotropy: "rate", period_along: "time", period_across: "time", axis: "angle", damping_anisotropy: "decay",
    damping_axis: "angle",
  },
  bob: { radius: "length", diameter: "length", density: "density", thread_mass: "mass", air_density: "density" },
  drive: { push: "speed", phase: "angle", radius: "length" },
  output: { duration: "time" },
} as const satisfies Record<string, Record<string, Holds>>;

export const LAUNCHES = {
  ellipse: { a: "length", b: "length", azimuth: "angle" },
  apsides: { a: "length", b: "length", azimuth: "angle" },
  plane: { x: "length", y: "length", vx: "speed", vy: "speed" },
  angles: { theta: "angle", phi: "angle", theta_rate: "rate", phi_rate: "rate" },
  state: { position: "vector of length", velocity: "vector of speed" },
  at_rest: { theta: "angle", phi: "angle" },
} as const satisfies Record<string, Record<string, Holds>>;

/** Keys without which their table means nothing; of a launch all but these have a default. */
export const NEEDED: Readonly<Record<string, readonly string[]>> = {
  pendulum: ["length"],
  site: ["latitude"],
  bob: ["density"],
  drive: ["push"],
};

export const OPTIONAL_OF_LAUNCHES: readonly string[] = ["azimuth", "phi", "theta_rate", "phi_rate"];

/** Ways to say the same thing: a table has one of them at most. */
export const ONE_OF: Readonly<Record<string, readonly (readonly string[])[]>> = {
  drag: [["linear"], ["quality"], ["half_life"], ["from_bob"]],
  suspension: [["anisotropy"], ["period_along", "period_across"]],
  bob: [["radius"], ["diameter"]],
  drive: [["phase"], ["radius"]],
};

/** Tables of which one of these ways must be there. */
export const ONE_NEEDED: readonly string[] = ["bob", "drive"];

/**
 * Units by kind, the SI unit first, then those in which smaller numbers are written: a power of ten of it, or a number
 * of it that no power of ten is.
 */
export const UNITS: Readonly<Record<Kind, readonly (readonly [unit: string, size: number | `e${number}`])[]>> = {
  length: [["m", "e0"], ["cm", "e-2"], ["mm", "e-3"], ["um", "e-6"], ["km", "e3"]],
  time: [["s", "e0"], ["ms", "e-3"], ["min", 60], ["h", 3600], ["d", 86400]],
  mass: [["kg", "e0"], ["g", "e-3"], ["mg", "e-6"]],
  acceleration: [["m/s^2", "e0"]],
  speed: [["m/s", "e0"], ["cm/s", "e-2"], ["mm/s", "e-3"], ["um/s", "e-6"]],
  angle: [["rad", "e0"], ["deg", Math.PI / 180]],
  rate: [["rad/s", "e0"], ["deg/s", Math.PI / 180]],
  density: [["kg/m^3", "e0"]],
  decay: [["1/s", "e0"]],
  quadratic: [["1/m", "e0"]],
  number: [["", "e0"]],
};
