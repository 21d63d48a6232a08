/** How numbers and quantities are said, in German and English; nothing here knows physics. */

import { DAY, DEGREE, HOUR, MINUTE, YEAR, unitFor, type Si } from "./ladders";

export type Language = "de" | "en";

/** Between a number and its unit, so that no line breaks there. */
const GAP = "\u00a0";
const THIN = "\u202f";

const formats = new Map<string, Intl.NumberFormat>();

function format(language: Language, options: Intl.NumberFormatOptions): Intl.NumberFormat {
  const key = language + JSON.stringify(options);
  let found = formats.get(key);
  if (!found) formats.set(key, (found = new Intl.NumberFormat(language === "de" ? "de-DE" : "en-GB", options)));
  return found;
}

const minus = (text: string): string => text.replace("-", "−");

export type Sign = "auto" | "exceptZero";

/** A number to so many significant digits, zeros at its end kept, since they were measured. */
export function significant(value: number, digits: number, language: Language, signDisplay: Sign = "auto"): string {
  const options = { minimumSignificantDigits: digits, maximumSignificantDigits: digits, useGrouping: false, signDisplay };
  return minus(format(language, options).format(value));
}

/** A number to so many decimals. */
export function decimals(value: number, count: number, language: Language, signDisplay: Sign = "auto"): string {
  const rounded = Math.abs(value) < 0.5 * 10 ** -count ? 0 : value;
  const options = { minimumFractionDigits: count, maximumFractionDigits: count, useGrouping: false, signDisplay };
  return minus(format(language, options).format(rounded));
}

/** A number without zeros at its end. */
export function plain(value: number, digits: number, language: Language): string {
  return minus(format(language, { maximumSignificantDigits: digits, useGrouping: false }).format(value));
}

/** A whole number with its thousands apart: by a thin space in German, by a comma in English. */
export function grouped(value: number, language: Language): string {
  const text = format(language, { useGrouping: true, maximumFractionDigits: 0 }).format(value);
  return minus(language === "de" ? text.replaceAll(".", THIN) : text);
}

/** A value given in SI, with the unit that suits it. */
export function quantity(value: number, si: Si, digits: number, language: Language): string {
  const unit = unitFor(value, si);
  if (value === 0) return `0${unit.symbol === "°" ? "" : GAP}${unit.symbol}`;
  return `${significant(value / unit.size, digits, language)}${unit.symbol === "°" ? "" : GAP}${unit.symbol}`;
}

/** A value as somebody would have given it: no zeros at its end that claim digits. */
export function asGiven(value: number, si: Si, language: Language, digits = 4): string {
  const unit = unitFor(value, si);
  return `${plain(value / unit.size, digits, language)}${unit.symbol === "°" ? "" : GAP}${unit.symbol}`;
}

/** An angle given in rad, in degrees to so many decimals. */
export function degrees(angle: number, count: number, language: Language, sign: Sign = "auto"): string {
  return `${decimals(angle / DEGREE, count, language, sign)}°`;
}

/** Slower turning than this is said in degrees an hour, rad/s. */
const SLOW = 0.01 * DEGREE;

/** The unit in which an angular velocity given in rad/s is said. */
export function rateUnit(rate: number): { readonly symbol: "°/s" | "°/h"; readonly size: number } {
  return Math.abs(rate) >= SLOW ? { symbol: "°/s", size: DEGREE } : { symbol: "°/h", size: DEGREE / HOUR };
}

/** An angular velocity given in rad/s: its size alone, since the sentence says the sense. */
export function rate(value: number, digits: number, language: Language): string {
  if (value === 0) return `0${GAP}°/h`;
  const { symbol, size } = rateUnit(value);
  return `${significant(Math.abs(value) / size, digits, language)}${GAP}${symbol}`;
}

/** An angular velocity given in rad/s, signed, in degrees an hour. */
export function ratePerHour(value: number, count: number, language: Language): string {
  return decimals((value * HOUR) / DEGREE, count, language, "exceptZero");
}

/** A time with up to two units: 2,037 s, 1 min 13 s, 4 h 17 min, 75,8 d. */
export function time(value: number, digits: number, language: Language): string {
  if (!Number.isFinite(value)) return "∞";
  const size = Math.abs(value);
  if (size < MINUTE) return quantity(value, "s", digits, language);
  const [large, small, bound] = size < HOUR ? (["min", "s", MINUTE] as const) : (["h", "min", HOUR] as const);
  if (size < 2 * DAY) {
    const steps = Math.round(value / (bound / 60));
    return `${Math.trunc(steps / 60)}${GAP}${large} ${Math.abs(steps % 60)}${GAP}${small}`;
  }
  if (size < 2 * YEAR) return `${significant(value / DAY, 3, language)}${GAP}d`;
  return `${significant(value / YEAR, 3, language)}${GAP}${language === "de" ? "Jahre" : "years"}`;
}

/** A moment as the timeline's handle shows it; `span` decides the unit, so that it stays while time runs, but for slow speeds. */
export function moment(value: number, span: number, language: Language, seconds = false): string {
  if (span < 10 * MINUTE || (seconds && value < 10 * MINUTE)) return `${decimals(value, 1, language)}${GAP}s`;
  if (span < 3 * HOUR || (seconds && value < HOUR)) return minutesAndSeconds(value);
  const minutes = Math.floor(value / MINUTE + 1e-9);
  return `${Math.floor(minutes / 60)}${GAP}h ${String(minutes % 60).padStart(2, "0")}${GAP}min`;
}

function minutesAndSeconds(value: number): string {
  const seconds = Math.floor(value + 1e-9);
  return `${Math.floor(seconds / 60)}${GAP}min ${String(seconds % 60).padStart(2, "0")}${GAP}s`;
}

/** A relative difference in per cent, two digits and no sign. */
export function percent(fraction: number, language: Language): string {
  const value = Math.abs(100 * fraction);
  return `${value >= 10 ? decimals(value, 0, language) : significant(value, 2, language)}${GAP}%`;
}

/** One part in so many, to two digits: 1 : 100 000. */
export function oneIn(fraction: number, language: Language): string {
  return `1${GAP}:${GAP}${grouped(Number((1 / fraction).toPrecision(2)), language)}`;
}
