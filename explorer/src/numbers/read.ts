/** Quantities as somebody types them: "67 m", "1,5 m", "3cm", "45°", "20 min". */

import { readQuantity, type Kind } from "../job";
import type { Si } from "./ladders";

const KINDS = { m: "length", "m/s": "speed", "m/s²": "acceleration", rad: "angle", s: "time" } as const satisfies Record<Si, Kind>;

/** The value in SI, or nothing where the text is no number or its unit is none of these. */
export function readTyped(text: string, si: Si): number | undefined {
  const plain = text
    .trim()
    .replaceAll(/[\u00a0\u202f]/g, " ")
    .replace(",", ".")
    .replace("−", "-")
    .replaceAll(/[µμ]/g, "u")
    .replace("²", "^2")
    .replace(/ *(°|grad)$/i, " deg")
    .replace(/ *std$/i, " h")
    .replace(/ +/g, " ");
  // A plain angle is in degrees, as people say it.
  const bare = si === "rad" && /^[+-]?[\d.]+$/.test(plain);
  return readQuantity(bare ? `${plain} deg` : plain, KINDS[si]) ?? undefined;
}
