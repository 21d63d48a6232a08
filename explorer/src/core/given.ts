/**
 * What is given: the tables of a job file with its own keys, in SI; angles in rad, positive
 * counter-clockwise seen from above, z down from the support. A key that is missing takes the
 * default of the job file. The core checks all of it.
 */
export interface Given {
  readonly pendulum: PendulumGiven;
  readonly launch: LaunchGiven;
  readonly site?: SiteGiven;
  readonly drag?: DragGiven;
  readonly suspension?: SuspensionGiven;
  readonly bob?: BobGiven;
  readonly drive?: DriveGiven;
}

export interface PendulumGiven {
  /** m */
  readonly length: number;
  /** m/s²; standard gravity, or that of the site */
  readonly gravity?: number;
  /** kg; 1 kg, or that of the bob */
  readonly mass?: number;
}

export type LaunchGiven =
  | { readonly kind: "ellipse" | "apsides"; readonly a: number; readonly b: number; readonly azimuth?: number }
  | { readonly kind: "plane"; readonly x: number; readonly y: number; readonly vx: number; readonly vy: number }
  | {
      readonly kind: "angles";
      readonly theta: number;
      readonly phi?: number;
      readonly theta_rate?: number;
      readonly phi_rate?: number;
    }
  | { readonly kind: "at_rest"; readonly theta: number; readonly phi?: number }
  | { readonly kind: "state"; readonly position: Vector; readonly velocity: Vector };

export type Vector = readonly [x: number, y: number, z: number];

export interface SiteGiven {
  /** rad, positive in the north */
  readonly latitude: number;
  readonly gravity?: number;
  readonly height?: number;
}

export interface DragGiven {
  /** γ, 1/s */
  readonly linear?: number;
  readonly quality?: number;
  /** s */
  readonly half_life?: number;
  readonly from_bob?: boolean;
  readonly thread_diameter?: number;
  /** c, 1/m */
  readonly quadratic?: number;
}

export interface SuspensionGiven {
  /** δ, rad/s */
  readonly anisotropy?: number;
  readonly period_along?: number;
  readonly period_across?: number;
  readonly axis?: number;
  /** Δγ, 1/s */
  readonly damping_anisotropy?: number;
  readonly damping_axis?: number;
}

export interface BobGiven {
  readonly radius?: number;
  readonly diameter?: number;
  readonly density: number;
  readonly thread_mass?: number;
  readonly air_density?: number;
}

export interface DriveGiven {
  /** m/s, away from the axis, once in each half swing */
  readonly push: number;
  readonly phase?: number;
  readonly radius?: number;
}
