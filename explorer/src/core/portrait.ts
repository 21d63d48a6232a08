/** The sphere of all ellipses of one size in one clamp. */
import type { EllipseNow, Form, Portrait, Verdict } from "./core";
import type { Machine } from "./machine";

export const VERDICTS: readonly Verdict[] = ["round", "to and fro", "stands"];

/** Of what the core has just told. */
export function portraitOf(machine: Machine): Portrait {
  const told = machine.told.slice() as unknown as Record<number, number>;
  const at = (slot: number) => told[slot] ?? Number.NaN;
  const [rotation, anisotropy, axis, intrinsic] = [at(0), at(1), at(2), at(3)];
  const { call } = machine;
  return {
    axis,
    form: { circularity: at(4), longitude: at(5) },
    orbit: {
      limits: [at(7), at(8)],
      verdict: VERDICTS[at(9)] as Verdict,
      period: at(10),
      rate: at(11),
      slowest: at(12),
      fastest: at(13),
      azimuths: [at(14), at(15)],
    },
    equilibria: Array.from({ length: at(16) }, (_, index) => {
      const slot = 17 + 3 * index;
      return { circularity: at(slot), longitude: at(slot + 1), stable: at(slot + 2) === 1 };
    }),
    place({ a, b, azimuth }: EllipseNow): Form {
      call.portrait_form(axis, a, b, azimuth);
      return { circularity: machine.at(0), longitude: machine.at(1) };
    },
    path({ circularity, longitude }: Form, count: number) {
      return machine.through([], 2 * count, (_, out) =>
        call.portrait_path(rotation, anisotropy, axis, intrinsic, circularity, longitude, count, out));
    },
    verdicts(forms: Float64Array) {
      const count = forms.length / 2;
      const found = machine.through(forms, count, (input, out) =>
        call.portrait_verdicts(rotation, anisotropy, axis, intrinsic, input, count, out));
      return Array.from(found, (number) => VERDICTS[number] as Verdict);
    },
  };
}
