/** How fast time runs: seconds of the pendulum in one second of the page. */

import { HOUR, MINUTE } from "../numbers/ladders";

export const FREE_SPEEDS: readonly number[] = [0.125, 0.25, 0.5, 1, 2, 5, 20];
export const FOUCAULT_SPEEDS: readonly number[] = [1, 10, MINUTE, 10 * MINUTE, HOUR, 6 * HOUR];

const FRACTIONS: ReadonlyMap<number, string> = new Map([
  [0.125, "⅛"],
  [0.25, "¼"],
  [0.5, "½"],
]);

/** "½×" or "20×". */
export function times(speed: number): string {
  return `${FRACTIONS.get(speed) ?? speed}×`;
}

/** What one second of the page is there: "1 min", "6 h". */
export function span(speed: number): string {
  return speed >= HOUR ? `${speed / HOUR}\u00a0h` : speed >= MINUTE ? `${speed / MINUTE}\u00a0min` : `${speed}\u00a0s`;
}

/** The next speed of a ladder, or null at its end. */
export function nextSpeed(ladder: readonly number[], speed: number, way: 1 | -1): number | null {
  const sorted = way > 0 ? ladder : [...ladder].reverse();
  return sorted.find((one) => way * (one - speed) > 1e-9) ?? null;
}

/**
 * Faster than this, in swings a second of the page, the bob would be a flicker: a swing would have
 * fewer than 16 frames.
 */
export const MOST_SWINGS = 30 / 8;
