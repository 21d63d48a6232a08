/** What turns the plane, cause by cause: bars from one zero line. */

import { useRef } from "preact/hooks";
import { DEGREE, HOUR } from "../numbers/ladders";
import { ratePerHour } from "../numbers/spell";
import type { Shares } from "../core";
import { launches, live, shownTime } from "../state/page";
import { language, words } from "../words/language";

const ROWS = [
  ["earth", "earth", "--linear"],
  ["ellipse", "intrinsic", "--ellipse"],
  ["suspension", "anisotropy", "--soft"],
  ["damping", "damping", "--soft"],
  ["drive", "drive", "--soft"],
  ["total", "total", "--exact"],
] as const satisfies readonly (readonly [string, keyof Shares, string])[];

/** The scale shrinks only when it has been too large for so long, ms; it grows at once. */
const SHRINK = 2000;

/** rad/s: what is less acts so little that it is said to be nothing. */
const NOTHING = (5e-4 * DEGREE) / HOUR;

export function SharesView() {
  void [shownTime.value, launches.value];
  const scale = useRef<{ low: number; high: number; since: number }>({ low: 0, high: 0, since: 0 });
  const now = live.value;
  const shares = now?.averaged?.reach(shownTime.value) ? now.averaged.shares(shownTime.value) : null;
  const say = words.value.foucault;
  const values = ROWS.map(([, key]) => shares?.[key] ?? 0);
  const [low, high] = [Math.min(0, ...values), Math.max(0, ...values)];
  const kept = scale.current;
  const time = performance.now();
  if (low < kept.low || high > kept.high) scale.current = { low: Math.min(low, kept.low), high: Math.max(high, kept.high), since: time };
  else if (high - low > 0.7 * (kept.high - kept.low)) kept.since = time;
  else if (time - kept.since > SHRINK) scale.current = { low, high, since: time };
  const { low: from, high: to } = scale.current;
  const range = to - from || 1;
  // Where nothing acts the zero line stands in the middle.
  const zero = to === from ? 50 : (-100 * from) / range;
  return (
    <section class="shares" aria-label={say.causes}>
      <div class="heading">
        <h2>{say.causes}</h2>
        <span>{say.unit}</span>
      </div>
      <dl>
        {ROWS.map(([name, key, color]) => {
          const value = shares?.[key] ?? 0;
          const acts = Math.abs(value) > NOTHING;
          const [left, right] = [Math.min(0, value), Math.max(0, value)].map((one) => (100 * (one - from)) / range) as [number, number];
          return (
            <div key={name} class={acts ? `share ${name}` : `share ${name} idle`}>
              <dt>{say[name]}</dt>
              <dd class="bar" aria-hidden="true">
                <i class="zero" style={{ left: `${zero}%` }} />
                {acts && <b style={{ left: `${left}%`, width: `${Math.max(right - left, 0.6)}%`, background: `var(${color})` }} />}
              </dd>
              <dd class="number">{acts ? ratePerHour(value, 2, language.value) : "0"}</dd>
            </div>
          );
        })}
      </dl>
    </section>
  );
}
