/** The rungs beside the exact motion: each switched on or off, with its distance from the bob now. */

import { useRef } from "preact/hooks";
import { STROKES, type Drawn } from "../drawing/strokes";
import { percent, quantity } from "../numbers/spell";
import { redraw } from "../state/loop";
import { beside, clock, kiosk, launches, live, shownTime, toggleRung } from "../state/page";
import { RUNGS, type Live, type Rung } from "../state/live";
import { fill, language, words } from "../words/language";
import { derivation, ReadOut } from "../sentence/ReadOut";

const EQUATIONS: Record<Drawn, string> = { exact: "12", cubic: "13", ellipse: "20", linear: "16" };

/** A swatch as the legend of a line: its dash, and the bob on it. */
function Swatch({ drawn }: { readonly drawn: Drawn }) {
  const { ink, dash, width } = STROKES[drawn];
  const color = `var(--${ink})`;
  return (
    <svg viewBox="0 0 54 18" aria-hidden="true">
      <path d="M1 9h52" stroke={color} stroke-width={drawn === "exact" ? 2.4 : width} stroke-dasharray={dash.join(" ")} stroke-linecap={dash[0] !== undefined && dash[0] < 1 ? "round" : "butt"} />
      <circle cx="27" cy="9" r={drawn === "exact" ? 6 : 4.6} fill={drawn === "exact" ? "var(--brass)" : "var(--paper)"} stroke={drawn === "exact" ? "var(--brass-dark)" : color} stroke-width={drawn === "exact" ? 1 : 2.4} />
    </svg>
  );
}

function Equation({ drawn }: { readonly drawn: Drawn }) {
  const number = `(${EQUATIONS[drawn]})`;
  if (kiosk.value) return <span class="equation">{number}</span>;
  return (
    <a class="equation" href={derivation(EQUATIONS[drawn])} target="_blank" rel="noopener" aria-label={fill(words.value.formulas.equation, { number })}>
      {number}
    </a>
  );
}

/** The largest distance that was seen of each rung since the launch, m. */
const largest = new Map<Rung, number>();
let measuredLaunch = -1;

function distance(now: Live, rung: Rung): number | null {
  if (measuredLaunch !== launches.value) {
    measuredLaunch = launches.value;
    largest.clear();
  }
  const motion = now.rungs.get(rung)?.motion;
  if (!motion) return null;
  const here = now.main.motion.distances(motion, Float64Array.of(clock.time))[0] ?? Number.NaN;
  if (Number.isNaN(here)) return null;
  largest.set(rung, Math.max(largest.get(rung) ?? 0, here));
  return here;
}

export function Formulas() {
  void [shownTime.value, launches.value];
  const now = live.value;
  const say = words.value.formulas;
  return (
    <section class="formulas" aria-label={say.label}>
      <div class="heading">
        <h2>{say.label}</h2>
        <span class="only-broad">{say.distance}</span>
      </div>
      <ul class="rows">
        <li class="row">
          <span class="toggle">
            <Swatch drawn="exact" />
            {say.exact}
          </span>
          <Equation drawn="exact" />
          <span class="value quiet">{say.drawn}</span>
        </li>
        {RUNGS.map((rung) => (
          <Row key={rung} rung={rung} live={now} />
        ))}
      </ul>
    </section>
  );
}

function Row({ rung, live: now }: { readonly rung: Rung; readonly live: Live | null }) {
  void shownTime.value;
  const say = words.value.formulas;
  const on = beside.value.has(rung);
  const moving = now?.rungs.get(rung)?.motion;
  const holds = moving !== undefined && (moving.ended === null || shownTime.value < moving.ended.time);
  const shown = useRef<string>("");
  const here = now && holds ? distance(now, rung) : null;
  // Where a formula starts alike there is no distance yet.
  shown.current = here === null ? "–" : here < 1e-9 * (now?.given.pendulum.length ?? 1) ? "–" : quantity(here, "m", here < 0.1 ? 2 : 3, language.value);
  return (
    <li class="row">
      <button
        type="button"
        class="toggle"
        aria-pressed={on && holds}
        disabled={!holds}
        onClick={() => {
          toggleRung(rung);
          redraw();
        }}
      >
        <Swatch drawn={rung} />
        {say[rung]}
      </button>
      <Equation drawn={rung} />
      {!holds ? (
        <span class="value quiet small">{say.below}</span>
      ) : !on ? (
        <span class="value quiet">{say.off}</span>
      ) : (
        <ReadOut className="value" value={shown.current} title={say[rung]} text={now ? detail(now, rung) : ""} equation={EQUATIONS[rung]} />
      )}
    </li>
  );
}

/** How far off it has been, and how wrong its period and its precession are. */
function detail(now: Live, rung: Rung): string {
  const say = words.value.formulas;
  const tongue = language.value;
  const errors = now.measured(rung);
  const error = (value: number | null, more: string, less: string): string =>
    value === null ? "" : Math.abs(value) < 1e-12 ? say.right : fill(value > 0 ? more : less, { error: percent(value, tongue) });
  const precession = errors?.precession === 0 ? say.none : error(errors?.precessionError ?? null, say.tooFast, say.tooSlow);
  const holes = {
    most: quantity(largest.get(rung) ?? 0, "m", 3, tongue),
    period: error(errors?.periodError ?? null, say.tooLong, say.tooShort),
    precession,
  };
  return fill(precession ? say.detail : say.detailPeriod, holes);
}
