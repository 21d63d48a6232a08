/** What the stage says: the hint, every enlargement, and what has gone wrong. */

import { plain, time } from "../numbers/spell";
import { averaging, gripped, mode, launches, live, pulledOnce, relaunch, rod, shownTime, speed, launch, given } from "../state/page";
import type { Live } from "../state/live";
import { redraw } from "../state/loop";
import { span } from "../state/speeds";
import { fill, language, words } from "../words/language";
import { Hand } from "../page/icons";
import { Filled } from "../sentence/Filled";
import { enlarged } from "./averaged";

export function Notes({ flat }: { readonly flat: "space" | "flat" | "lost" }) {
  const say = words.value.stage;
  return (
    <>
      {!pulledOnce.value && mode.value === "free" && (
        <p class="hint">
          <Hand />
          <span>{say.pull}</span>
        </p>
      )}
      {!gripped.value && <Enlargement />}
      {flat !== "space" && (
        <p class="stage-foot" role="status">
          {flat === "flat" ? say.flat : say.lost}
        </p>
      )}
      <Ended />
    </>
  );
}

/** Whatever is drawn larger or faster than it is, is said to be. */
function Enlargement() {
  void [launches.value, shownTime.value];
  const now = live.value;
  if (!now) return null;
  const say = words.value.stage;
  const tongue = language.value;
  if (averaging.value) {
    const by = enlarged(now);
    const lapse = <strong>{fill(words.value.time.lapseSentence, { span: span(speed.value) })}</strong>;
    const same = by.long === 1 && by.wide === 1;
    return (
      <p class="stage-note">
        <Filled text={same ? say.averageShort : say.average} holes={{ speed: lapse, long: plain(by.long, 2, tongue), wide: plain(by.wide, 3, tongue) }} />
      </p>
    );
  }
  if (now.stretch === 1) return null;
  return <p class="stage-note">{fill(say.enlarged, { factor: plain(now.stretch, 2, tongue) })}</p>;
}

/** The drive that only keeps the swing as it is. */
function weaken({ settled: { sustaining } }: Live): void {
  if (sustaining) relaunch({ ...given.value, drive: sustaining });
  redraw();
}

/** Why the motion has stopped, and a way on. */
function Ended() {
  void shownTime.value;
  const now = live.value;
  const motion = averaging.value ? now?.averaged : now?.main.motion;
  const ended = motion?.ended;
  if (!now || !ended || shownTime.value < ended.time * (1 - 1e-9)) return null;
  const say = words.value.stage.ended;
  const kind = ended.why === "slack" ? "slack" : ended.why === "level" ? "pumped" : averaging.value ? "circle" : "other";
  return (
    <div class="ended" role="status">
      {fill(say[kind], { time: time(ended.time, 3, language.value) })}
      {kind === "slack" && !rod.value && (
        <button
          type="button"
          class="chip"
          onClick={() => {
            rod.value = true;
            launch(given.value);
            redraw();
          }}
        >
          {words.value.notice.slackChip}
        </button>
      )}
      {kind === "pumped" && given.value.drive && now.settled.sustaining && (
        <button type="button" class="chip" onClick={() => weaken(now)}>
          {words.value.notice.weakerChip}
        </button>
      )}
    </div>
  );
}
