/** What follows on the turning ground: what the Earth alone would do, and what the plane does now. */

import { DEGREE, HOUR } from "../numbers/ladders";
import { decimals, degrees, rate, ratePerHour, significant } from "../numbers/spell";
import { meetingNow } from "../state/curves";
import type { Live } from "../state/live";
import { launches, live, mode, shownTime } from "../state/page";
import { language, words } from "../words/language";
import { Filled } from "../sentence/Filled";
import { ReadOut } from "../sentence/ReadOut";

/** Less than this share of the Earth's rate is called standing. */
const STANDS = 0.01;

export function NowSentence() {
  void [shownTime.value, launches.value];
  const now = live.value;
  if (!now) return null;
  if (mode.value === "pair") return <Pair live={now} />;
  const say = words.value.follows;
  const explain = words.value.explain;
  const tongue = language.value;
  const { earth } = now.settled;
  const perHour = (value: number): string => `${decimals((Math.abs(value) * HOUR) / DEGREE, 2, tongue)}\u00a0°/h`;
  const text = earth === 0 ? say.earthNone : earth < 0 ? say.earthClockwise : say.earthCounter;
  return (
    <p class="sentence follows">
      <Filled text={text} holes={{ earth: <ReadOut value={perHour(earth)} {...explain.earth} full={`${significant((Math.abs(earth) * HOUR) / DEGREE, 7, tongue)} °/h`} /> }} />{" "}
      <Moment live={now} />
    </p>
  );
}

function Moment({ live: now }: { readonly live: Live }) {
  void shownTime.value;
  const say = words.value.follows;
  const explain = words.value.explain.now;
  const { earth } = now.settled;
  const total = now.averaged?.reach(shownTime.value) ? now.averaged.shares(shownTime.value)?.total : undefined;
  if (total === undefined) return null;
  const stands = earth === 0 ? Math.abs(total) < 1e-9 : Math.abs(total) < STANDS * Math.abs(earth);
  const full = `${ratePerHour(total, 5, language.value)} °/h`;
  const sense = earth === 0 && !stands ? ` ${total < 0 ? say.clockwise : say.counter}` : "";
  const value = stands ? say.stands : `${decimals((Math.abs(total) * HOUR) / DEGREE, 2, language.value)}\u00a0°/h${sense}`;
  const number = <ReadOut big value={value} {...explain} full={full} />;
  return <Filled text={stands ? say.standing : earth * total < 0 ? say.against : say.now} holes={{ now: number }} />;
}

/** Rounds over which the time of one is taken. */
const ROUNDS = 100;

/** s, once round, of a bob that circles; the number of rounds is known well enough from the small swing. */
function round(now: Live, which: "main" | "twin"): number {
  const motion = now[which]?.motion;
  const time = ROUNDS * now.settled.smallPeriod;
  if (!motion?.reach(time)) return Number.NaN;
  const places = motion.positions(Float64Array.of(0, time));
  const angle = (index: number): number => Math.atan2(places[3 * index + 1] ?? 0, places[3 * index] ?? 0);
  const sense = which === "main" ? 1 : -1;
  const rest = sense * (angle(1) - angle(0));
  const turned = 2 * Math.PI * ROUNDS + Math.atan2(Math.sin(rest), Math.cos(rest));
  return (time * 2 * Math.PI) / turned;
}

let rounds: { readonly live: Live; readonly main: number; readonly twin: number } | null = null;

function Pair({ live: now }: { readonly live: Live }) {
  void shownTime.value;
  const say = words.value.follows;
  const explain = words.value.explain;
  const tongue = language.value;
  if (rounds?.live !== now || Number.isNaN(rounds.main + rounds.twin)) rounds = { live: now, main: round(now, "main"), twin: round(now, "twin") };
  const time = shownTime.value;
  const met = meetingNow(now) ?? Number.NaN;
  const seconds = (value: number): string => (Number.isNaN(value) ? "…" : `${significant(value, 6, tongue)}\u00a0s`);
  const angle = (value: number): string => (Number.isNaN(value) ? "…" : degrees(value, 2, tongue, "exceptZero"));
  return (
    <p class="sentence follows">
      <Filled
        text={say.pair}
        holes={{
          ccw: <ReadOut value={seconds(rounds.main)} {...explain.pair} />,
          cw: <ReadOut value={seconds(rounds.twin)} {...explain.pair} />,
          turned: <ReadOut big value={angle(met - now.hand.azimuth)} {...explain.turned} />,
          earth: <ReadOut value={angle(now.settled.earth * time)} {...explain.earth} full={rate(now.settled.earth, 7, tongue)} />,
        }}
      />
    </p>
  );
}
