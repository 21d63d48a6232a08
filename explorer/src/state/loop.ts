/** The frames of the page: time goes on, and everything that is drawn is drawn. */

import { beside, averaging, clock, duration, live, playing, shownTime, speed, waiting } from "./page";

type Painter = () => void;

const painters = new Set<Painter>();
let requested = false;
let before: number | null = null;
let said = 0;

/** How long a frame may count, s: after a hidden tab nothing jumps. */
const LONGEST_FRAME = 0.1;

/** The said time changes so often at most, ms. */
const SAY_EVERY = 200;

/** Draws with each frame; gives back how to stop it. */
export function onFrame(painter: Painter): () => void {
  painters.add(painter);
  redraw();
  return () => void painters.delete(painter);
}

/** Asks for a frame. */
export function redraw(): void {
  if (requested) return;
  requested = true;
  requestAnimationFrame(frame);
}

function frame(now: number): void {
  requested = false;
  const passed = before === null ? 0 : Math.min((now - before) / 1000, LONGEST_FRAME);
  before = playing.value ? now : null;
  if (playing.value && !waiting.value) goOn(passed * speed.value);
  const there = live.value?.follow(clock.time, beside.value, averaging.value) ?? true;
  if (now - said >= SAY_EVERY || !playing.value) {
    said = now;
    shownTime.value = clock.time;
  }
  for (const painter of painters) painter();
  if (playing.value || !there || waiting.value) redraw();
}

function goOn(step: number): void {
  const now = live.value;
  if (!now) return;
  let next = clock.time + step;
  const ended = (averagingMotion() ?? now.main.motion).ended;
  if (ended && next >= ended.time) {
    next = ended.time;
    playing.value = false;
  }
  clock.time = next;
  // The timeline grows when time runs out of it.
  if (next > duration.value) duration.value *= 2;
}

function averagingMotion() {
  return averaging.value ? (live.value?.averaged ?? null) : null;
}

/** Puts the clock to a time. */
export function seek(time: number): void {
  const now = live.value;
  const ended = now ? (averagingMotion() ?? now.main.motion).ended : null;
  clock.time = Math.max(0, Math.min(time, ended ? ended.time : Number.POSITIVE_INFINITY));
  shownTime.value = clock.time;
  redraw();
}

/** One forty-eighth of a swing, or a minute where days run in seconds. */
export function step(): void {
  playing.value = false;
  const now = live.value;
  if (now) seek(clock.time + (averaging.value ? 60 : now.period / 48));
}
