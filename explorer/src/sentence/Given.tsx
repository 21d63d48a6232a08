/** The first sentence: what is given. Its quantities are the controls of the page. */

import { quantity } from "../numbers/spell";
import { given, live, mode, refused, relaunch, ruling } from "../state/page";
import { bodyOf } from "../state/quantities";
import { redraw } from "../state/loop";
import { language, words } from "../words/language";
import { refusal } from "../words/sentences";
import type { Given as GivenJob } from "../core";
import { Filled } from "./Filled";
import { QuantityButton } from "./Quantity";
import { ReadOut } from "./ReadOut";
import { Ruler } from "./Ruler";

export function Given() {
  return (
    <section id="given" aria-label={words.value.given.label}>
      <p class="sentence given">{mode.value === "free" ? <Free /> : mode.value === "pair" ? <Pair /> : <Foucault />}</p>
      {ruling.value ? (
        <Ruler />
      ) : (
        refused.value && (
          <p class="refusal" role="status">
            {refusal(refused.value, language.value)}
          </p>
        )
      )}
      <hr class="rule" />
    </section>
  );
}

function Free() {
  const now = live.value;
  if (!now) return null;
  const say = words.value.given;
  const body = bodyOf(now.settled.gravity);
  const rod = now.summary.tension[0] < 0;
  const place = (
    <Filled
      text={body ? say[body] : say.somewhere}
      holes={{ gravity: body ? <QuantityButton name="gravity" text={words.value.bodies[body]} /> : <QuantityButton name="gravity" /> }}
    />
  );
  return (
    <Filled
      text={now.hand.oblique ? say.oblique : say.free}
      holes={{
        length: <QuantityButton name="length" />,
        wire: <Wire rod={rod} slack={now.summary.slackTime} />,
        place,
        pull: <QuantityButton name="pull" />,
        push: now.hand.speed === 0 ? <QuantityButton name="push" text={words.value.ruler.still} /> : <QuantityButton name="push" />,
      }}
    />
  );
}

/** The word is "rod" as soon as a thread would have to push; a tap says where it would go slack. */
function Wire({ rod, slack }: { readonly rod: boolean; readonly slack: number }) {
  const say = words.value;
  if (!rod) return <>{say.given.thread}</>;
  const full = Number.isFinite(slack) ? say.stage.ended.slack.replace("{time}", quantity(slack, "s", 3, language.value)) : "";
  return <ReadOut value={say.given.rod} title={say.explain.rod.title} text={`${say.explain.rod.text} ${full}`.trim()} />;
}

function Pair() {
  return <Filled text={words.value.given.cone} holes={{ length: <QuantityButton name="length" />, pull: <QuantityButton name="pull" /> }} />;
}

function Foucault() {
  const now = live.value;
  if (!now) return null;
  const say = words.value.given;
  const braked = Number.isFinite(now.settled.halfLife);
  const uneven = now.settled.anisotropy !== 0;
  return (
    <Filled
      text={say.foucault}
      holes={{
        length: <QuantityButton name="length" />,
        pull: <QuantityButton name="pull" />,
        drag: <Filled text={braked ? say.drag : say.noDrag} holes={{ value: <QuantityButton name="halfLife" /> }} />,
        clamp: <Filled text={uneven ? say.clamp : say.evenClamp} holes={{ value: <QuantityButton name="clamp" /> }} />,
        drive: <Drive />,
      }}
    />
  );
}

/** The drive that was switched off, and of which pendulum it was. */
let kept: Pick<GivenJob, "pendulum" | "drive"> | null = null;

function Drive() {
  const say = words.value.given;
  const { drive, ...rest } = given.value;
  const on = kept?.pendulum === rest.pendulum ? kept.drive : live.value?.settled.sustaining;
  const toggle = (): void => {
    if (drive) kept = { pendulum: rest.pendulum, drive };
    relaunch(drive || !on ? rest : { ...rest, drive: on });
    redraw();
  };
  // Where nothing brakes there is nothing to keep up.
  if (!drive && !on) return <>{say.free_}</>;
  return (
    <button type="button" class="quantity" style={{ cursor: "pointer" }} aria-pressed={drive !== undefined} onClick={toggle}>
      {drive ? say.driven : say.free_}
    </button>
  );
}
