/** What a hand takes hold of on the stage: the bob, and the tip of the arrow that pushes it. */

import { useRef } from "preact/hooks";
import { degrees, quantity } from "../numbers/spell";
import { averaging, clock, gripped, kiosk, live, mode } from "../state/page";
import type { Live } from "../state/live";
import { fill, language, words } from "../words/language";
import { arrow, cancel, grip, moveThrough, pullOut, pushAcross, release } from "./grip";
import { place } from "./over";
import { camera } from "./sight";
import { placed } from "../drawing/scene";
import { Hand } from "../page/icons";
import { enlarged } from "./averaged";
import { led, type Passed } from "./travel";

/** A finger covers what it holds: the bob is held above it, px. */
const ABOVE_FINGER = 36;

export function Handles() {
  const grabbed = useRef<{ id: number; lift: number } | null>(null);
  const pushing = useRef<{ x: number; y: number; from: number; along: readonly [number, number] } | null>(null);
  const say = words.value.stage;
  const now = live.value;
  if (!now) return null;

  const local = (event: PointerEvent): readonly [number, number] => {
    const area = (event.currentTarget as HTMLElement).parentElement?.getBoundingClientRect();
    return [event.clientX - (area?.left ?? 0), event.clientY - (area?.top ?? 0)];
  };
  const onKey = (event: KeyboardEvent): void => {
    const share = event.shiftKey ? 0.1 : 1;
    const pull = 0.01 * now.given.pendulum.length * share;
    const push = 0.02 * now.settled.speed * share;
    if (event.key === " ") (gripped.value ? release() : grip());
    else if (event.key === "Escape" && gripped.value) cancel();
    else if (event.key === "ArrowUp" || event.key === "ArrowDown") pullOut(event.key === "ArrowUp" ? pull : -pull);
    else if ((event.key === "ArrowLeft" || event.key === "ArrowRight") && mode.value === "free") {
      if (!gripped.value) grip();
      pushAcross((live.value?.hand.across ?? 0) + (event.key === "ArrowRight" ? push : -push));
    } else return;
    event.preventDefault();
    event.stopPropagation();
  };

  return (
    <>
      <div
        class="bob-handle"
        role="application"
        tabIndex={0}
        aria-label={say.bob}
        aria-roledescription={say.bob}
        aria-describedby="bob-help"
        onKeyDown={onKey}
        onPointerDown={(event) => {
          if (event.button !== 0 || grabbed.current) return;
          event.currentTarget.setPointerCapture(event.pointerId);
          grabbed.current = { id: event.pointerId, lift: event.pointerType === "touch" ? ABOVE_FINGER : 0 };
          grip();
        }}
        onPointerMove={(event) => {
          if (grabbed.current?.id !== event.pointerId) return;
          const { lift } = grabbed.current;
          const [x, y] = local(event);
          // A browser hands out one event a frame; what lies between tells how fast the hand is.
          const between = event.getCoalescedEvents?.() ?? [];
          const way = (between.length > 0 ? between : [event]).map((one) => ({ x: x + one.clientX - event.clientX, y: y + one.clientY - event.clientY - lift, time: one.timeStamp }));
          moveThrough(way);
        }}
        onPointerUp={(event) => {
          if (grabbed.current?.id !== event.pointerId) return;
          grabbed.current = null;
          release(event.timeStamp);
        }}
        onPointerCancel={() => {
          grabbed.current = null;
          cancel();
        }}
      />
      {gripped.value && mode.value === "free" && !kiosk.value && (
        <div
          class="push-handle"
          onPointerDown={(event) => {
            const found = arrow();
            if (!found) return;
            event.currentTarget.setPointerCapture(event.pointerId);
            const way = Math.hypot(found.tip[0] - found.from[0], found.tip[1] - found.from[1]) || 1;
            const sense = (live.value?.hand.across ?? 0) < 0 ? -1 : 1;
            const along = [(sense * (found.tip[0] - found.from[0])) / way, (sense * (found.tip[1] - found.from[1])) / way] as const;
            pushing.current = { x: event.clientX, y: event.clientY, from: live.value?.hand.across ?? 0, along };
          }}
          onPointerMove={(event) => {
            const [held, found] = [pushing.current, arrow()];
            if (!held || !found) return;
            const way = (event.clientX - held.x) * held.along[0] + (event.clientY - held.y) * held.along[1];
            pushAcross(held.from + way * found.perPixel);
          }}
          onPointerUp={() => {
            pushing.current = null;
          }}
        />
      )}
      {gripped.value && <Flags live={now} />}
      {led.value && (
        <div class="pale-hand">
          <Hand />
        </div>
      )}
      <span id="bob-help" class="unseen">
        {say.bobHelp}
      </span>
    </>
  );
}

function Flags({ live: now }: { readonly live: Live }) {
  const tongue = language.value;
  const high = now.hand.angle > Math.PI / 2;
  const text = high ? degrees(now.hand.angle, 1, tongue) : `${quantity(now.hand.pull, "m", 3, tongue)} · ${degrees(now.hand.angle, 1, tongue)}`;
  const push = mode.value === "free" && !kiosk.value ? `${words.value.stage.arrow} ${quantity(Math.abs(now.hand.across), "m/s", 3, tongue)}` : "";
  return (
    <>
      <div class="flag pull-flag">{text}</div>
      {push && <div class="flag push-flag">{push}</div>}
    </>
  );
}

/** What is spoken of a held bob. */
export function heldWords(now: Live): string {
  const tongue = language.value;
  return fill(words.value.stage.state, {
    pull: quantity(now.hand.pull, "m", 3, tongue),
    angle: degrees(now.hand.angle, 1, tongue),
    push: quantity(Math.abs(now.hand.across), "m/s", 3, tongue),
  });
}

/** Puts what can be taken hold of where it is drawn. */
export function placeHandles(box: HTMLElement, now: Live, way: Passed | null): void {
  const put = (selector: string, x: number, y: number): void => {
    const element = box.querySelector<HTMLElement>(selector);
    if (element) element.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
  };
  const there = bobPlace(now);
  const at = camera.project(way ? way.at(there) : there);
  put(".bob-handle", at.x, at.y);
  put(".pale-hand", at.x, at.y);
  if (!gripped.value) return;
  put(".pull-flag", at.x + 34, at.y + 22);
  const found = arrow();
  if (!found) return;
  put(".push-handle", ...found.tip);
  put(".push-flag", found.tip[0] - 40, found.tip[1] - 52);
}

function bobPlace(now: Live): readonly [number, number, number] {
  if (gripped.value) return place(now);
  if (averaging.value) {
    const ellipse = now.ellipse(clock.time);
    if (!ellipse) return [0, 0, -1];
    const far = (enlarged(now).long * ellipse.a) / now.given.pendulum.length;
    return [far * Math.cos(ellipse.azimuth), far * Math.sin(ellipse.azimuth), -Math.sqrt(Math.max(0, 1 - far * far))];
  }
  const { points, head } = now.main.trace;
  return placed(points[3 * head] ?? 0, points[3 * head + 1] ?? 0, points[3 * head + 2] ?? 0, now.stretch);
}
