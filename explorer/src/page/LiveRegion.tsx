/** The state in words, for those who do not see it: spoken on change, not with each frame. */

import { useEffect, useState } from "preact/hooks";
import { degrees, moment, quantity } from "../numbers/spell";
import { clock, duration, gripped, launches, live, mode, playing, preset } from "../state/page";
import { heldWords } from "../stage/Handles";
import { fill, language, presetWords, words } from "../words/language";

/** Rest after which it is spoken, ms. */
const REST = 400;

export function LiveRegion() {
  const [text, setText] = useState("");
  const watched = [launches.value, gripped.value, playing.value, preset.value, language.value];
  useEffect(() => {
    const timer = setTimeout(() => setText(now()), REST);
    return () => clearTimeout(timer);
  }, watched);
  return (
    <p class="unseen" role="status" data-live>
      {text}
    </p>
  );
}

/** What is shown now, in one or two sentences. */
function now(): string {
  const shown = live.value;
  if (!shown) return "";
  if (gripped.value) return heldWords(shown);
  const say = words.value.live;
  const title = preset.value ? presetWords.value[preset.value].title : words.value.gallery.own;
  const time = moment(clock.time, duration.value, language.value);
  const running = playing.value ? say.playing : say.paused;
  if (mode.value === "foucault") {
    const ellipse = shown.ellipse(clock.time);
    const turned = ellipse ? degrees(ellipse.azimuth - shown.hand.azimuth, 1, language.value) : "–";
    return `${fill(say.foucault, { title, time, turned })} ${running}`;
  }
  const state = shown.main.motion.state(clock.time);
  const radius = state ? quantity(Math.hypot(state.position[0], state.position[1]), "m", 3, language.value) : "–";
  return `${fill(say.free, { title, time, radius })} ${running}`;
}
