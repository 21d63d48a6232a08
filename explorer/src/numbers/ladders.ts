/** Units that a reader takes in at a glance, largest last, by the SI unit of what is said. */

export interface Unit {
  readonly symbol: string;
  /** Of one of it, in the SI unit. */
  readonly size: number;
  /** The value in the SI unit from which on it is used. */
  readonly from: number;
}

export const DEGREE = Math.PI / 180;
export const MINUTE = 60;
export const HOUR = 3600;
export const DAY = 86_400;
export const YEAR = 365.25 * DAY;

const unit = (symbol: string, size: number, from = size): Unit => ({ symbol, size, from });

export type Si = "m" | "m/s" | "m/s²" | "rad" | "s";

export const LADDERS: Record<Si, readonly Unit[]> = {
  m: [unit("nm", 1e-9), unit("µm", 1e-6), unit("mm", 1e-3), unit("cm", 1e-2), unit("m", 1), unit("km", 1e3, 1e4)],
  "m/s": [
    unit("nm/s", 1e-9),
    unit("µm/s", 1e-6),
    unit("mm/s", 1e-3),
    unit("cm/s", 1e-2),
    unit("m/s", 1),
    unit("km/s", 1e3, 1e4),
  ],
  "m/s²": [unit("m/s²", 1)],
  rad: [unit("°", DEGREE)],
  s: [
    unit("µs", 1e-6),
    unit("ms", 1e-3),
    unit("s", 1),
    unit("min", MINUTE, 2 * MINUTE),
    unit("h", HOUR, 2 * HOUR),
    unit("d", DAY, 3 * DAY),
  ],
};

/** The largest unit that is in use at this size. */
export function unitFor(value: number, si: Si): Unit {
  const ladder = LADDERS[si];
  const size = Math.abs(value) * (1 + 1e-9);
  let found = ladder[0] as Unit;
  for (const next of ladder) if (size >= next.from) found = next;
  // Zero is said in the middle of the ladder: 0 mm, not 0 nm.
  return value === 0 ? (ladder.find((one) => one.symbol.startsWith("mm")) ?? (ladder.find((one) => one.size === 1) as Unit) ?? found) : found;
}
