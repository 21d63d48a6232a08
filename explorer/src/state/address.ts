/** The state as the fragment of the address: read once, and written whenever something has been changed. */

import { readLink, writeLink, type Beside } from "../job";
import { PRESET_KEYS, type PresetKey } from "../words/presets";
import { language } from "../words/language";
import { redraw, seek } from "./loop";
import { beside, clock, deviation, duration, given, gripped, kiosk, launch, notice, preset, refused, rod, show, speed, speeds } from "./page";
import { PRESETS } from "./presets";
import type { Rung } from "./live";

function known(name: string | undefined): PresetKey | null {
  return PRESET_KEYS.find((key) => key === name) ?? null;
}

/** Takes the state of a fragment; what is garbled gives the rosette and a notice. */
export function take(fragment: string): void {
  const link = readLink(fragment);
  notice.value = link.garbled ? "link" : null;
  if (link.view.lang) language.value = link.view.lang;
  kiosk.value = link.view.kiosk ?? false;
  if (link.view.beside) beside.value = new Set<Rung>(link.view.beside);
  const key = known(link.view.preset);
  if (!link.given) {
    show(key ?? "rosette");
    if (link.view.t !== undefined) seek(link.view.t);
    return;
  }
  rod.value = link.view.rod ?? false;
  if (!launch(link.given, link.view.t ?? 0)) {
    const why = refused.value;
    show("rosette");
    notice.value = why ?? "link";
    return;
  }
  preset.value = key && JSON.stringify(PRESETS[key].given) === JSON.stringify(link.given) ? key : null;
  const chosen = preset.value ? PRESETS[preset.value] : null;
  duration.value = link.duration ?? chosen?.duration ?? (link.given.site ? 86_400 : 40);
  deviation.value = chosen?.deviation ?? false;
  speed.value = chosen?.speed ?? (link.given.site ? 3600 : 1);
  if (!speeds.value.includes(speed.value)) speed.value = speeds.value[0] ?? 1;
  redraw();
}

/** The fragment of what is shown now. */
export function written(): string {
  const view = {
    ...(preset.value && { preset: preset.value }),
    lang: language.value,
    ...(kiosk.value && { kiosk: true }),
    ...(rod.value && { rod: true }),
    ...(beside.value.size < 3 && { beside: [...beside.value] as Beside[] }),
  };
  return writeLink({ given: given.value, duration: duration.value, view });
}

/** The link with the moment in it, as it is shared. */
export function shared(): string {
  return `${location.href.replace(/#.*$/, "")}#${written()}&t=${Number(clock.time.toPrecision(6))}`;
}

/** Keeps the address up to date; each motion that is let go is a step of the history, so that Back undoes it. */
export function remember(step: boolean): void {
  if (gripped.value) return;
  const next = `#${written()}`;
  if (next === location.hash) return;
  if (step) history.pushState(null, "", next);
  else history.replaceState(null, "", next);
}
