/** A job file that `kugelpendel run` takes, of what the page shows. */
import type { Given } from "../core";
import { LAUNCHES, TABLES, type Holds, type Kind } from "./keys";
import { writeQuantity } from "./quantity";

/** Rows of the track that the job writes. */
const SAMPLES = 1001;

/** Its text; the duration in s. */
export function writeJobFile(given: Given, duration: number): string {
  const { launch } = given;
  const sections = Object.entries(given).map(([table, entries]) => {
    const keys: Readonly<Record<string, Holds>> =
      table === "launch" ? LAUNCHES[launch.kind] : TABLES[table as keyof typeof TABLES];
    const lines = Object.entries(entries as Record<string, unknown>).flatMap(([key, value]) => {
      if (value === undefined) return [];
      const holds = keys[key];
      return [`${key} = ${holds === undefined ? JSON.stringify(value) : written(value, holds)}`];
    });
    return [`[${table}]`, ...lines, ""];
  });
  const output = ["[output]", `duration = "${writeQuantity(duration, "time")}"`, `samples = ${SAMPLES}`, ""];
  return [...sections.flat(), ...output].join("\n");
}

function written(value: unknown, holds: Holds): string {
  switch (holds) {
    case "truth":
      return String(value === true);
    case "vector of length":
      return vector(value, "length");
    case "vector of speed":
      return vector(value, "speed");
    case "number":
      return String(value);
    default:
      return `"${writeQuantity(value as number, holds)}"`;
  }
}

function vector(value: unknown, kind: Kind): string {
  return `[${(value as readonly number[]).map((number) => `"${writeQuantity(number, kind)}"`).join(", ")}]`;
}
