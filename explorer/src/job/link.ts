/**
 * A state of the page as the fragment of its address: `pendulum.length=1&launch.kind=plane&…`, the keys of job files with
 * their tables, and a few of the page's own. A link is somebody else's text: whatever is not exactly what is expected
 * makes the whole link void, and nothing of it goes anywhere but into numbers and into words of these lists.
 */
import type { Given } from "../core";
import { LAUNCHES, NEEDED, ONE_NEEDED, ONE_OF, OPTIONAL_OF_LAUNCHES, TABLES, type Holds, type Kind } from "./keys";
import { readQuantity } from "./quantity";

/** What the page shows beside the motion; its keys stand in a link by themselves. */
export interface View {
  readonly preset?: string;
  readonly lang?: "de" | "en";
  readonly kiosk?: boolean;
  /** Whether the support is a rod. */
  readonly rod?: boolean;
  /** s */
  readonly t?: number;
  readonly beside?: readonly Beside[];
}

export const BESIDE = ["linear", "ellipse", "cubic"] as const;
export type Beside = (typeof BESIDE)[number];

export interface Link {
  /** What moves; none where the link says nothing of it. */
  readonly given: Given | null;
  /** s */
  readonly duration: number | null;
  readonly view: View;
}

/** What a fragment says; `garbled` where anything in it is not understood, and then it says nothing. */
export interface ReadLink extends Link {
  readonly garbled: boolean;
}

/** Longer ones are not looked at: a link of the page has some hundred characters. */
const LONGEST = 4000;

type Value = number | boolean | string | readonly number[];
type Entries = Map<string, Value>;

class Garbled extends Error {}

/** Of the fragment, with or without its #. */
export function readLink(fragment: string): ReadLink {
  try {
    return { ...understood(fragment.replace(/^#/, "")), garbled: false };
  } catch (error) {
    if (!(error instanceof Garbled || error instanceof URIError)) throw error;
    return { given: null, duration: null, view: {}, garbled: true };
  }
}

/** Without the #; the same state gives the same link. */
export function writeLink({ given, duration, view }: Link): string {
  const parts: string[] = [];
  for (const [table, keys] of Object.entries(given ?? {})) {
    for (const [key, value] of Object.entries(keys as Record<string, Value | undefined>)) {
      if (value !== undefined) parts.push(`${table}.${key}=${String(value)}`);
    }
  }
  if (duration !== null) parts.push(`output.duration=${duration}`);
  for (const [key, value] of Object.entries(view) as [string, Value | undefined][]) {
    if (value === true) parts.push(`${key}=1`);
    else if (value !== undefined && value !== false) parts.push(`${key}=${String(value)}`);
  }
  return parts.join("&");
}

function understood(text: string): Link {
  const { tables, own } = takenApart(text);
  const output = tables.get("output");
  tables.delete("output");
  const duration = output?.get("duration") ?? null;
  if (duration !== null && !(typeof duration === "number" && duration > 0)) throw new Garbled();
  return { given: tables.size === 0 ? null : given(tables), duration, view: view(own) };
}

function takenApart(text: string): { tables: Map<string, Entries>; own: Map<string, string> } {
  if (text.length > LONGEST) throw new Garbled();
  const said = new Map<string, string>();
  for (const part of text === "" ? [] : text.split("&")) {
    const [name = "", value, ...rest] = part.split("=");
    if (value === undefined || rest.length > 0 || said.has(name)) throw new Garbled();
    said.set(name, decodeURIComponent(value.replaceAll("+", " ")));
  }
  const [tables, own] = [new Map<string, Entries>(), new Map<string, string>()];
  const launch = LAUNCHES[known(said.get("launch.kind") ?? "angles", LAUNCHES)];
  for (const [name, value] of said) {
    const [table = "", key, ...rest] = name.split(".");
    if (key === undefined) {
      own.set(name, value);
      continue;
    }
    if (rest.length > 0) throw new Garbled();
    const entries = tables.get(table) ?? new Map<string, Value>();
    tables.set(table, entries);
    if (table === "launch" && key === "kind") {
      entries.set(key, value);
      continue;
    }
    const keys: Readonly<Record<string, Holds>> = table === "launch" ? launch : TABLES[known(table, TABLES)];
    const holds = keys[known(key, keys)];
    if (holds === undefined) throw new Garbled();
    entries.set(key, valueOf(value, holds));
  }
  return { tables, own };
}

/** A name, if it is one of an object's own. */
function known<T extends object>(name: string, of: T): keyof T {
  if (!Object.hasOwn(of, name)) throw new Garbled();
  return name as keyof T;
}

function valueOf(text: string, holds: Holds): Value {
  if (holds === "truth") return known(text, { true: 0, false: 0 }) === "true";
  if (holds === "vector of length" || holds === "vector of speed") {
    const numbers = text.split(",").map((component) => numberOf(component, holds === "vector of length" ? "length" : "speed"));
    if (numbers.length !== 3) throw new Garbled();
    return numbers;
  }
  return numberOf(text, holds);
}

function numberOf(text: string, kind: Kind): number {
  const number = readQuantity(text, kind);
  if (number === null) throw new Garbled();
  return number;
}

function given(tables: Map<string, Entries>): Given {
  for (const needed of ["pendulum", "launch"]) if (!tables.has(needed)) throw new Garbled();
  for (const [table, entries] of tables) {
    const kind = entries.get("kind");
    const needed =
      table === "launch"
        ? Object.keys(LAUNCHES[known(String(kind), LAUNCHES)]).filter((key) => !OPTIONAL_OF_LAUNCHES.includes(key))
        : (NEEDED[table] ?? []);
    if (needed.some((key) => !entries.has(key))) throw new Garbled();
    const ways = (ONE_OF[table] ?? []).filter((way) => way.some((key) => entries.has(key)));
    if (ways.length > 1 || ways.some((way) => !way.every((key) => entries.has(key)))) throw new Garbled();
    if (ways.length === 0 && ONE_NEEDED.includes(table)) throw new Garbled();
  }
  const drag = tables.get("drag");
  const estimated = drag?.get("from_bob") === true;
  if (estimated && (!tables.has("bob") || drag?.has("quadratic"))) throw new Garbled();
  if (!estimated && drag?.has("thread_diameter")) throw new Garbled();
  const objects = [...tables].map(([table, entries]) => [table, Object.fromEntries(entries)]);
  return Object.fromEntries(objects) as Given;
}

function view(own: Map<string, string>): View {
  const found: { -readonly [Key in keyof View]: View[Key] } = {};
  for (const [name, text] of own) {
    if (name === "preset" && /^[a-z]{1,20}$/.test(text)) found.preset = text;
    else if (name === "lang" && (text === "de" || text === "en")) found.lang = text;
    else if (name === "kiosk" && text === "1") found.kiosk = true;
    else if (name === "rod" && text === "1") found.rod = true;
    else if (name === "t") found.t = numberOf(text, "time");
    else if (name === "beside") found.beside = text === "" ? [] : text.split(",").map(beside);
    else throw new Garbled();
  }
  return found;
}

function beside(text: string): Beside {
  const found = BESIDE.find((law) => law === text);
  if (found === undefined) throw new Garbled();
  return found;
}
