/** Numbers with a unit, read out of a link and written into a job file. */
import { UNITS, type Kind } from "./keys";

const TEXT = /^([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?) ?([a-z/^\d]*)$/i;

/** Digits after which a number of degrees is no longer what a person wrote. */
const DIGITS = 12;

/** In SI; null where it is no number with a unit of its kind. A plain number is in SI. */
export function readQuantity(text: string, kind: Kind): number | null {
  const [, digits = "", name = ""] = TEXT.exec(text) ?? [];
  if (digits === "") return null;
  const found = name === "" ? (["", "e0"] as const) : UNITS[kind].find(([unit]) => unit === name);
  const value = found === undefined ? Number.NaN : inSi(digits, found[1]);
  return Number.isFinite(value) ? value : null;
}

/** The shortest of its texts, such as "45 cm"; one that reads as the same number again. */
export function writeQuantity(value: number, kind: Kind): string {
  const [si, ...others] = UNITS[kind];
  let best = `${value} ${si?.[0] ?? ""}`.trimEnd();
  for (const [unit, size] of others) {
    const per = typeof size === "number" ? size : Number(`1${size}`);
    const digits = String(Number((value / per).toPrecision(DIGITS)));
    // An angle in degrees is taken to be meant where it is the same to the last rounding.
    const same = typeof size === "number" && !Number.isInteger(size)
      ? Math.abs(inSi(digits, size) - value) <= Number.EPSILON * Math.abs(value)
      : inSi(digits, size) === value;
    const text = `${digits} ${unit}`;
    if (same && text.length < best.length) best = text;
  }
  return best;
}

/** By the exponent, powers of ten are rounded once, as they are in a job file. */
function inSi(digits: string, size: number | `e${number}`): number {
  if (typeof size === "number") return Number(digits) * size;
  const [mantissa = "", exponent = "0"] = digits.toLowerCase().split("e");
  return Number(`${mantissa}e${Number(exponent) + Number(size.slice(1))}`);
}
