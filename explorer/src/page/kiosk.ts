/** On a screen in a museum: no way out by touch, and after a while without anybody it begins again. */

import { effect, signal, untracked } from "@preact/signals";
import type { Language } from "../numbers/spell";
import { redraw } from "../state/loop";
import { gripped, kiosk, mode, playing, preset, pulledOnce, reducedMotion } from "../state/page";
import { PRESET_KEYS, type PresetKey } from "../words/presets";
import { language } from "../words/language";
import { goHome } from "../stage/sight";
import { endTravel, leadBack, led, travelTo } from "../stage/travel";

/** Rest after which it asks whether somebody is there, and how long it waits for an answer, ms. */
const IDLE = 45_000;
const ASKED = 15_000;

/** How often a pale hand shows what can be done while nobody is there, ms; each third time it takes the next example. */
const ATTRACT = 20_000;
const NEXT = 3;

/** How long Escape is held down to leave, ms: nobody does so by touch, or by chance. */
const LEAVE = 3000;

/** Whether "Still there?" is shown. */
export const asking = signal(false);

function leaveKiosk(): void {
  kiosk.value = false;
  asking.value = false;
  if (document.fullscreenElement) void document.exitFullscreen();
}

function fill(): void {
  if (document.fullscreenElement || matchMedia("(display-mode: fullscreen)").matches) return;
  // Refused, the page stays as it is: the program that opened it has the screen.
  void document.documentElement.requestFullscreen?.().catch(() => undefined);
}

/** Begins to watch; gives back how to stop. */
export function watchKiosk(): () => void {
  const home: { preset: PresetKey; language: Language } = { preset: preset.value ?? "rosette", language: language.value };
  let timer = 0;
  let attract = 0;

  const begin = (key: PresetKey, byHand: boolean): void => {
    travelTo(key, byHand);
    pulledOnce.value = false;
    playing.value = true;
    redraw();
  };
  let shown = 0;
  const attracting = (): void => {
    shown++;
    const at = PRESET_KEYS.indexOf(preset.value ?? home.preset);
    if (shown % NEXT === 0) begin(PRESET_KEYS[(at + 1) % PRESET_KEYS.length] ?? home.preset, true);
    else leadBack();
    attract = window.setTimeout(attracting, ATTRACT);
  };
  const leave = (): void => {
    asking.value = false;
    language.value = home.language;
    begin(home.preset, false);
    playing.value = !reducedMotion.value;
    goHome(mode.value === "free" ? "free" : "foucault");
    shown = 0;
    // Nobody is there, until somebody touches the screen. Who wants less motion sees the first example only.
    if (!reducedMotion.value) attract = window.setTimeout(attracting, ATTRACT);
  };
  const ask = (): void => {
    if (gripped.value) return touched();
    asking.value = true;
    timer = window.setTimeout(leave, ASKED);
  };
  const touched = (): void => {
    asking.value = false;
    if (led.value) endTravel();
    clearTimeout(timer);
    clearTimeout(attract);
    timer = window.setTimeout(ask, IDLE);
  };
  const stay = (event: Event): void => event.preventDefault();
  let held = 0;
  const released = (event: KeyboardEvent): void => {
    if (event.key !== "Escape") return;
    clearTimeout(held);
    held = 0;
  };
  const pressed = (event: KeyboardEvent): void => {
    if (event.key === "Escape" && held === 0) held = window.setTimeout(leaveKiosk, LEAVE);
  };
  window.addEventListener("keydown", pressed);
  window.addEventListener("keyup", released);
  // A browser lets a page fill the screen only when somebody touches it.
  window.addEventListener("pointerup", fill);
  const events = ["pointerdown", "pointermove", "keydown"] as const;
  for (const name of events) window.addEventListener(name, touched, { passive: true });
  for (const name of ["contextmenu", "dragstart", "gesturestart"]) window.addEventListener(name, stay);
  touched();
  return () => {
    clearTimeout(held);
    window.removeEventListener("keydown", pressed);
    window.removeEventListener("keyup", released);
    window.removeEventListener("pointerup", fill);
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
