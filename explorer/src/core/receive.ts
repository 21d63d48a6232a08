/** What is given, laid into the slots in which the core receives it; NaN for a key that is missing. */
import type { Given, LaunchGiven } from "./given";

/** The kinds of launch that the core knows, by their numbers; one at rest is one by its angles. */
const KINDS = { ellipse: 0, apsides: 1, plane: 2, angles: 3, at_rest: 3, state: 4 } as const;

export function slots({ pendulum, launch, site, drag, suspension, bob, drive }: Given): number[] {
  const radius = bob?.radius ?? (bob?.diameter === undefined ? undefined : bob.diameter / 2);
  const rotation = undefined; // that of the Earth
  const all = [
    pendulum.length, pendulum.gravity, pendulum.mass,
    KINDS[launch.kind], ...filled(numbers(launch)),
    site?.latitude, site?.gravity, site && (site.height ?? 0), rotation,
    drag?.linear, drag?.quadratic,
    suspension?.anisotropy, suspension?.axis, suspension?.damping_anisotropy, suspension?.damping_axis,
    radius, bob?.density, bob?.thread_mass, bob?.air_density,
    drive?.push, drive?.phase, drive?.radius,
    drag?.quality, drag?.half_life, drag?.from_bob ? 1 : undefined, drag?.thread_diameter,
    suspension?.period_along, suspension?.period_across,
  ];
  return all.map((value) => value ?? Number.NaN);
}

function numbers(launch: LaunchGiven): readonly number[] {
  switch (launch.kind) {
    case "ellipse":
    case "apsides":
      return [launch.a, launch.b, launch.azimuth ?? 0];
    case "plane":
      return [launch.x, launch.y, launch.vx, launch.vy];
    case "angles":
      return [launch.theta, launch.phi ?? 0, launch.theta_rate ?? 0, launch.phi_rate ?? 0];
    case "at_rest":
      return [launch.theta, launch.phi ?? 0, 0, 0];
    case "state":
      return [...launch.position, ...launch.velocity];
  }
}

function filled(values: readonly number[]): number[] {
  return Array.from({ length: 6 }, (_, index) => values[index] ?? 0);
}
