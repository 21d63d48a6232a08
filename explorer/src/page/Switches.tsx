/** What is switched between two: modes and languages. In a kiosk they stand below as well, where a child or a wheelchair reaches. */

import { pick } from "../instruments/pick";
import { mode } from "../state/page";
import { language, words } from "../words/language";

/** The other mode begins with its first example. */
function showMode(next: "free" | "foucault"): void {
  if ((mode.value === "free") !== (next === "free")) pick(next === "free" ? "rosette" : "pantheon");
}

export function Modes() {
  const say = words.value;
  return (
    <div class="modes" role="group" aria-label={say.modes.label}>
      {(["free", "foucault"] as const).map((one) => (
        <button key={one} type="button" aria-pressed={(mode.value === "free") === (one === "free")} onClick={() => showMode(one)}>
          {say.modes[one]}
        </button>
      ))}
    </div>
  );
}

const IN_FULL = { de: "Deutsch", en: "English" } as const;

export function Languages({ inFull = false }: { readonly inFull?: boolean }) {
  return (
    <div class={inFull ? "languages always" : "languages"} role="group" aria-label={words.value.header.language}>
      {(["de", "en"] as const).map((one) => (
        <button key={one} type="button" lang={one} aria-pressed={language.value === one} onClick={() => (language.value = one)}>
          {inFull ? IN_FULL[one] : one.toUpperCase()}
          {!inFull && <span class="unseen"> {IN_FULL[one]}</span>}
        </button>
      ))}
    </div>
  );
}
