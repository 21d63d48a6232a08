/** From where the pendulum is seen. Space is in units of the length: x, y as from above, z up, support at 0. */

import { DEGREE } from "../numbers/ladders";

export type Point = readonly [x: number, y: number, z: number];

export interface Pixel {
  readonly x: number;
  readonly y: number;
  /** px that one length has there */
  readonly scale: number;
}

export interface Frame {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

export const ELEVATION = 20.6 * DEGREE;
export const DISTANCE = 4.2;

/** From where a camera looks and what its picture is like. */
export interface Pose {
  readonly azimuth: number;
  readonly elevation: number;
  readonly target: number;
  readonly focal: number;
  readonly centre: readonly [number, number];
}

export class Camera {
  azimuth = -35 * DEGREE;
  elevation = ELEVATION;
  private focal = 1;
  private centre: readonly [number, number] = [0, 0];
  /** What the camera looks at. */
  private target = -0.62;

  get pose(): Pose {
    const { azimuth, elevation, target, focal, centre } = this;
    return { azimuth, elevation, target, focal, centre };
  }

  set pose({ azimuth, elevation, target, focal, centre }: Pose) {
    [this.azimuth, this.elevation, this.target, this.focal, this.centre] = [azimuth, elevation, target, focal, centre];
  }

  /** Coordinates of a point to the right of, above and beyond the camera's axis. */
  private seen([x, y, z]: Point): readonly [number, number, number] {
    const [sinA, cosA] = [Math.sin(this.azimuth), Math.cos(this.azimuth)];
    const [sinE, cosE] = [Math.sin(this.elevation), Math.cos(this.elevation)];
    const toward = cosA * x + sinA * y;
    const up = z - this.target;
    return [cosA * y - sinA * x, cosE * up - sinE * toward, DISTANCE - cosE * toward - sinE * up];
  }

  project(point: Point): Pixel {
    const [right, up, depth] = this.seen(point);
    const scale = this.focal / depth;
    return { x: this.centre[0] + scale * right, y: this.centre[1] - scale * up, scale };
  }

  /** The camera's place and the direction of the ray through a pixel. */
  ray(x: number, y: number): { readonly eye: Point; readonly direction: Point } {
    const [sinA, cosA] = [Math.sin(this.azimuth), Math.cos(this.azimuth)];
    const [sinE, cosE] = [Math.sin(this.elevation), Math.cos(this.elevation)];
    const eye: Point = [DISTANCE * cosE * cosA, DISTANCE * cosE * sinA, this.target + DISTANCE * sinE];
    const right = (x - this.centre[0]) / this.focal;
    const up = (this.centre[1] - y) / this.focal;
    const direction: Point = [
      -cosE * cosA - right * sinA - up * sinE * cosA,
      -cosE * sinA + right * cosA - up * sinE * sinA,
      -sinE + up * cosE,
    ];
    return { eye, direction };
  }

  /** The rows that take a point to px right, px up and depth, for a shader. */
  rows(): readonly (readonly [number, number, number, number])[] {
    const zero = this.seen([0, 0, 0]);
    const units = ([[1, 0, 0], [0, 1, 0], [0, 0, 1]] as const).map((one) => this.seen(one));
    return [0, 1, 2].map((row) => {
      const at = (column: number): number => (units[column]?.[row] ?? 0) - (zero[row] ?? 0);
      return [at(0), at(1), at(2), zero[row] ?? 0] as const;
    });
  }

  get lens(): { readonly focal: number; readonly centre: readonly [number, number] } {
    return { focal: this.focal, centre: this.centre };
  }

  /** Takes the frame so that what has to be seen just fills it; `high` puts the support in the middle. */
  fit(frame: Frame, floorRadius: number, high: boolean): void {
    this.target = high ? -0.1 : -0.62;
    this.focal = 1;
    this.centre = [0, 0];
    const seen: Pixel[] = [this.project([0, 0, high ? 1.06 : 0.045])];
    for (let step = 0; step < 48; step++) {
      const angle = (step / 48) * 2 * Math.PI;
      const [x, y] = [Math.cos(angle), Math.sin(angle)];
      seen.push(this.project([floorRadius * x, floorRadius * y, FLOOR - 0.03]));
      if (high) seen.push(this.project([1.04 * x, 1.04 * y, 0]));
    }
    const xs = seen.map((one) => one.x);
    const ys = seen.map((one) => one.y);
    const [left, right, top, bottom] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    this.focal = Math.min(frame.width / (right - left), frame.height / (bottom - top));
    this.centre = [
      frame.left + frame.width / 2 - (this.focal * (left + right)) / 2,
      frame.top + frame.height / 2 - (this.focal * (top + bottom)) / 2,
    ];
  }
}

/** Height of the floor: a tenth of the length below the lowest point. */
export const FLOOR = -1.1;

/** Radius of the floor for a swing that reaches so far from the axis. */
export function floorRadius(reach: number): number {
  return Math.min(Math.max(1.32 * reach, 0.56), 0.78);
}
