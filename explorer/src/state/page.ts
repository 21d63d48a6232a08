/** What the page shows: the one place where it is kept. */

import { batch, computed, signal } from "@preact/signals";
import { Refused, type Core, type Given } from "../core";
import type { PresetKey } from "../words/presets";
import { Live, modeOf, RUNGS, type Rung } from "./live";
import { PRESETS } from "./presets";
import { FOUCAULT_SPEEDS, FREE_SPEEDS, MOST_SWINGS, nextSpeed } from "./speeds";

export const core = signal<Core | "loading">("loading");
export const live = signal<Live | null>(null);
export const given = signal<Given>(PRESETS.rosette.given);
/** The example that it is, or null for somebody's own launch. */
export const preset = signal<PresetKey | null>("rosette");
/** Whether the support is a rod, where that has to be said: on the turning ground. */
export const rod = signal(false);
export const beside = signal<ReadonlySet<Rung>>(new Set(RUNGS));
export const speed = signal(1);
export const playing = signal(false);
/** Whether time waits until the bob has come to where its motion begins. */
export const waiting = signal(false);
/** s: how much of the motion the timeline shows */
export const duration = signal(PRESETS.rosette.duration);
export const deviation = signal(false);
export const kiosk = signal(false);
export const theme = signal<"system" | "light" | "dark">("system");
export const systemDark = signal(false);
/** What is held at this moment by pointer or key. */
export const gripped = signal(false);
/** Whether somebody has pulled the bob in this visit. */
export const pulledOnce = signal(false);
/** A control that is open: the quantity whose ruler is shown. */
export const ruling = signal<string | null>(null);
export const notice = signal<"link" | Refused | null>(null);
/** What the core said to the last launch that it refused. */
export const refused = signal<Refused | null>(null);
/** What that launch was of. */
export const refusedGiven = signal<Given | null>(null);
export const reducedMotion = signal(false);

export const mode = computed(() => modeOf(given.value));
export const dark = computed(() => theme.value === "dark" || (theme.value === "system" && systemDark.value));
export const speeds = computed(() => (mode.value === "free" ? FREE_SPEEDS : FOUCAULT_SPEEDS));
/** Whether time runs so fast that the ellipse is drawn in place of the bob. */
export const averaging = computed(() => {
  const now = live.value;
  return now?.mode === "foucault" && speed.value / now.period > MOST_SWINGS;
});

/** s; not a signal, since it changes with every frame */
export const clock = { time: 0 };
/** The time as it is said, which changes at most five times a second. */
export const shownTime = signal(0);
/** Counts launches, for what has to begin anew with each. */
export const launches = signal(0);

/** Puts another motion in place of this one; false, with the reason in `refused`, where that cannot be. */
export function launch(next: Given, at = 0): boolean {
  const engine = core.value;
  if (typeof engine === "string") return false;
  try {
    const made = new Live(engine, next, rod.value, gripped.value ? (live.value?.stretch ?? null) : null);
    const old = live.value;
    batch(() => {
      clock.time = at;
      shownTime.value = at;
      given.value = next;
      live.value = made;
      refused.value = null;
      launches.value++;
    });
    old?.free();
    return true;
  } catch (error) {
    if (!(error instanceof Refused)) throw error;
    refusedGiven.value = next;
    refused.value = error;
    return false;
  }
}

/** Somebody's own launch: no example any more. */
export function relaunch(next: Given): boolean {
  if (!launch(next)) return false;
  preset.value = null;
  return true;
}

export function show(key: PresetKey): void {
  const chosen = PRESETS[key];
  batch(() => {
    rod.value = false;
    ruling.value = null;
    if (!launch(chosen.given, chosen.start)) return;
    preset.value = key;
    speed.value = chosen.speed;
    duration.value = chosen.duration;
    deviation.value = chosen.deviation ?? false;
  });
}

export function changeSpeed(way: 1 | -1): void {
  const next = nextSpeed(speeds.value, speed.value, way);
  if (next !== null) speed.value = next;
}

export function toggleRung(rung: Rung): void {
  const next = new Set(beside.value);
  if (!next.delete(rung)) next.add(rung);
  beside.value = next;
}
