/** What the page says where the core refuses something: the sentences that Python says, for who writes job files. */

import german from "../../../src/kugelpendel/errors/sentences/de.toml";
import english from "../../../src/kugelpendel/errors/sentences/en.toml";
import type { Refused, Seen } from "../core";
import type { Language } from "../numbers/spell";

/** Of a file of sentences, what the page is built with. */
export interface Sentences {
  readonly launch: string;
  readonly unnamed: string;
  readonly quantities: Readonly<Record<string, { readonly name: string; readonly wayOut: string }>>;
  /** Of each kind of refusal its sentence, with holes such as {shown} and {length:.6g}. */
  readonly kinds: Readonly<Record<string, string>>;
}

const SENTENCES: Readonly<Record<Language, Sentences>> = { de: german, en: english };

/** Parts whose values are shown to the last digit, as the exact motion takes them so. */
const EXACT: readonly string[] = ["pendulum", ""];

const HOLE = /\{(\w+)(?::\.(\d+)([fg]))?\}/g;

/** What was wrong, the values seen, and the way out. */
export function refusal({ kind, seen, message }: Refused, language: Language): string {
  const sentences = SENTENCES[language];
  const holes = new Map<string, string | number>();
  for (const one of [...seen].reverse()) {
    holes.set("name", one.name).set("value", one.value).set("unit", one.unit);
    holes.set(one.name.replaceAll(".", "_"), one.value);
  }
  const [first] = seen;
  if (first) for (const [name, text] of quantity(first, sentences)) holes.set(name, text);
  const said = (sentences.kinds[kind] ?? message).replace(HOLE, (_, name: string, digits?: string, form?: string) => {
    const value = holes.get(name) ?? "";
    if (typeof value === "string") return localized(value, name === "shown", language);
    return localized(written(value, digits === undefined ? null : Number(digits), form), true, language);
  });
  return said.replace(/\s+/g, " ").trim();
}

/** Spoken name, value with its unit, and way out; what has no entry keeps the core's name. */
function quantity({ name, value, unit }: Seen, { quantities, unnamed }: Sentences): readonly (readonly [string, string])[] {
  const entry = quantities[name] ?? { name, wayOut: unnamed };
  const part = name.slice(0, Math.max(0, name.lastIndexOf(".")));
  const shown = EXACT.includes(part) ? inFull(value) : general(value, 6);
  return [["spoken", entry.name], ["shown", `${shown} ${unit}`.trimEnd()], ["way_out", entry.wayOut]];
}

function written(value: number, digits: number | null, form?: string): string {
  if (digits === null) return inFull(value);
  return form === "f" && Number.isFinite(value) ? fixed(value, digits) : general(value, digits);
}

/** So many decimals, of however large a number. */
function fixed(value: number, digits: number): string {
  return Math.abs(value) < 1e21 ? value.toFixed(digits) : `${BigInt(value)}.${"0".repeat(digits)}`;
}

/** All digits, without an exponent where that is readable. */
function inFull(value: number): string {
  const size = Math.abs(value);
  if (!Number.isFinite(value)) return Number.isNaN(value) ? "NaN" : value > 0 ? "inf" : "-inf";
  if (size >= 1e16 || (size > 0 && size < 1e-9)) return value.toExponential();
  const [mantissa = "", exponent] = String(value).split("e");
  const digits = mantissa.replace(/[-.]/g, "").length;
  return exponent === undefined ? mantissa : value.toFixed(Math.max(0, digits - 1 - Number(exponent)));
}

/** So many significant digits at most, with an exponent for what is very large or very small. */
function general(value: number, digits: number): string {
  if (!Number.isFinite(value)) return inFull(value).toLowerCase();
  const [mantissa = "", exponent = "0"] = value.toExponential(digits - 1).split("e");
  const power = Number(exponent);
  const bare = (text: string): string => (text.includes(".") ? text.replace(/\.?0+$/, "") : text);
  if (power >= -4 && power < digits) return bare(value.toFixed(digits - 1 - power));
  return `${bare(mantissa)}e${power < 0 ? "-" : "+"}${String(Math.abs(power)).padStart(2, "0")}`;
}

/** A number with the signs that people write. */
function localized(text: string, isNumber: boolean, language: Language): string {
  if (!isNumber) return text;
  const signed = text.replace(/^-/, "−");
  return language === "de" ? signed.replace(".", ",") : signed;
}
