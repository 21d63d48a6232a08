/** On a screen in a museum: no way out by touch, and after a while without anybody it begins again. */

import { effect, signal, untracked } from "@preact/signals";
import type { Language } from "../numbers/spell";
import { redraw } from "../state/loop";
import { gripped, kiosk, mode, playing, preset, pulledOnce, reducedMotion, show } from "../state/page";
import { PRESET_KEYS, type PresetKey } from "../words/presets";
import { language } from "../words/language";
import { goHome } from "../stage/sight";

/** Rest after which it asks whether somebody is there, and how long it waits for an answer, ms. */
const IDLE = 45_000;
const ASKED = 15_000;

/** How often it shows another example while nobody is there, ms. */
const ATTRACT = 60_000;

/** Whether "Still there?" is shown. */
export const asking = signal(false);

/** Begins to watch; gives back how to stop. */
export function watchKiosk(): () => void {
  const home: { preset: PresetKey; language: Language } = { preset: preset.value ?? "rosette", language: language.value };
  let timer = 0;
  let attract = 0;

  const begin = (key: PresetKey): void => {
    asking.value = false;
    language.value = home.language;
    show(key);
    pulledOnce.value = false;
    goHome(mode.value === "free" ? "free" : "foucault");
    playing.value = !reducedMotion.value;
    redraw();
  };
  const next = (): void => {
    const at = PRESET_KEYS.indexOf(preset.value ?? home.preset);
    begin(PRESET_KEYS[(at + 1) % PRESET_KEYS.length] ?? home.preset);
    attract = window.setTimeout(next, ATTRACT);
  };
  const leave = (): void => {
    begin(home.preset);
    // Nobody is there: other examples pass by until somebody touches one. Who wants less motion sees one of them only.
    if (!reducedMotion.value) attract = window.setTimeout(next, ATTRACT);
  };
  const ask = (): void => {
    if (gripped.value) return touched();
    asking.value = true;
    timer = window.setTimeout(leave, ASKED);
  };
  const touched = (): void => {
    asking.value = false;
    clearTimeout(timer);
    clearTimeout(attract);
    timer = window.setTimeout(ask, IDLE);
  };
  const stay = (event: Event): void => event.preventDefault();
  const events = ["pointerdown", "pointermove", "keydown"] as const;
  for (const name of events) window.addEventListener(name, touched, { passive: true });
  for (const name of ["contextmenu", "dragstart", "gesturestart"]) window.addEventListener(name, stay);
  touched();
  return () => {
    clearTimeout(timer);
    clearTimeout(attract);
    for (const name of events) window.removeEventListener(name, touched);
    for (const name of ["contextmenu", "dragstart", "gesturestart"]) window.removeEventListener(name, stay);
  };
}

/** Watches whenever the page is a kiosk. */
export function keepKiosk(): void {
  let stop: (() => void) | null = null;
  effect(() => {
    if (kiosk.value && !stop) stop = untracked(watchKiosk);
    else if (!kiosk.value) {
      stop?.();
      stop = null;
    }
  });
}
