/** The second sentence: what follows from what is given, never a number that means nothing. */

import type { Summary } from "../core";
import { DEGREE } from "../numbers/ladders";
import { decimals, percent, quantity, rate, rateUnit, significant, time } from "../numbers/spell";
import { kiosk, live } from "../state/page";
import { language, words } from "../words/language";
import { Filled } from "./Filled";
import { derivation, ReadOut } from "./ReadOut";

/** Rounder ellipses than this have no direction that an eye sees. */
const ROUND = 0.8;

/** Which of the sentences says something about a motion of the ideal pendulum. */
export function sentenceKind({ regime, inner, outer }: Summary): "ellipse" | "high" | "circle" | "plane" | "rotation" | "rest" | "balance" | "separatrix" {
  if (regime === "cone") return "circle";
  if (regime === "above") return "high";
  if (regime === "ellipse") return inner < ROUND * outer ? "ellipse" : "high";
  return regime;
}

export function Follows() {
  const now = live.value;
  if (!now) return null;
  const say = words.value.follows;
  const kind = sentenceKind(now.summary);
  // From one highest point to the next: further round in the sense of the motion, or back.
  const step = Math.abs(now.summary.apsidalAngle);
  const back = kind === "high" && now.summary.regime === "above" && Math.PI < step && step < 2 * Math.PI && step > 1.9 * Math.PI;
  const text = back ? say.back : say[kind];
  return (
    <>
      <p class="sentence follows">
        <Filled text={text} holes={numbers(now.summary, back)} />
      </p>
      <FormulaNote summary={now.summary} />
    </>
  );
}

function numbers(summary: Summary, back: boolean) {
  const say = words.value.explain;
  const tongue = language.value;
  const full = (value: number): string => quantity(value, "s", 7, tongue);
  const turning = Math.abs(summary.turning);
  const unit = rateUnit(turning);
  const step = back ? 2 * Math.PI - Math.abs(summary.apsidalAngle) : Math.abs(summary.apsidalAngle);
  const sense = summary.turning < 0 ? words.value.follows.clockwise : words.value.follows.counter;
  return {
    period: <ReadOut value={quantity(summary.swingPeriod, "s", summary.swingPeriod < 10 ? 4 : 5, tongue)} {...say.period} full={full(summary.swingPeriod)} equation="26" />,
    rate: (
      <ReadOut
        big
        value={rate(turning, 3, tongue)}
        title={say.rate.title}
        text={say.rate.text.replace("{sense}", sense)}
        full={`${significant(turning / unit.size, 7, tongue)} ${unit.symbol}`}
        equation="25"
      />
    ),
    turn: <ReadOut value={time(summary.fullTurn, 3, tongue)} {...say.turn} full={full(summary.fullTurn)} />,
    between: <ReadOut value={quantity(summary.radialPeriod, "s", 4, tongue)} {...say.between} full={full(summary.radialPeriod)} />,
    step: <ReadOut big value={`${decimals(step / DEGREE, 1, tongue)}°`} {...say.step} full={`${decimals(step / DEGREE, 5, tongue)}°`} />,
    round: <ReadOut big value={quantity(summary.onceRound, "s", 4, tongue)} {...say.round} full={full(summary.onceRound)} />,
  };
}

/** What formula (25) makes of it, and by how much it errs. */
function FormulaNote({ summary }: { readonly summary: Summary }) {
  const say = words.value.follows;
  const explain = words.value.explain;
  const tongue = language.value;
  const source = !kiosk.value && (
    <>
      {" "}
      <a href={derivation("25")} target="_blank" rel="noopener">
        {say.source}
      </a>
    </>
  );
  const { formula25, error25 } = summary;
  if (formula25 === null || error25 === null || formula25 === 0) {
    if (summary.regime !== "above") return null;
    return (
      <p class="note formula-note">
        <Filled text={say.none} holes={{ number: "(25)" }} />
        {source}
      </p>
    );
  }
  const unit = rateUnit(formula25);
  const close = Math.abs(error25) < 5e-7;
  const value = rate(formula25, Math.abs(error25) < 0.005 ? 4 : 3, tongue);
  const holes = {
    number: "(25)",
    rate: <ReadOut value={value} {...explain.formula} full={`${significant(Math.abs(formula25) / unit.size, 7, tongue)} ${unit.symbol}`} equation="25" />,
    error: <ReadOut value={percent(error25, tongue)} {...explain.error} full={`${significant(100 * error25, 5, tongue)} %`} />,
  };
  return (
    <p class="note formula-note">
      <Filled text={close ? say.same : error25 < 0 ? say.less : say.more} holes={holes} />
      {source}
    </p>
  );
}
