/** Twelve examples, each by its own drawing. */

import { computed } from "@preact/signals";
import { useState } from "preact/hooks";
import { Languages, Modes } from "../page/Switches";
import { core, kiosk, preset } from "../state/page";
import { PRESET_KEYS, type PresetKey } from "../words/presets";
import { presetWords, words } from "../words/language";
import { pick } from "./pick";
import { thumbOf, type Thumb } from "./thumbs";

const thumbs = computed<Partial<Record<PresetKey, Thumb>>>(() => {
  const engine = core.value;
  if (typeof engine === "string") return {};
  return Object.fromEntries(PRESET_KEYS.map((key) => [key, thumbOf(engine, key)]));
});

export function Gallery() {
  const [open, setOpen] = useState(false);
  const say = words.value.gallery;
  return (
    <nav class={open ? "gallery open" : "gallery"} aria-label={say.label}>
      <button type="button" class="gallery-button chip" aria-expanded={open} onClick={() => setOpen(!open)}>
        {say.open}
      </button>
      <ol>
        {PRESET_KEYS.map((key) => (
          <li key={key} class={key === "pantheon" ? "apart" : ""}>
            <button
              type="button"
              class="thumb"
              aria-pressed={preset.value === key}
              onClick={() => {
                setOpen(false);
                pick(key);
              }}
            >
              <Drawing thumb={thumbs.value[key]} />
              <span>{presetWords.value[key].name}</span>
            </button>
          </li>
        ))}
      </ol>
      {kiosk.value && (
        <div class="within-reach">
          <Modes />
          <Languages inFull />
        </div>
      )}
    </nav>
  );
}

function Drawing({ thumb }: { readonly thumb: Thumb | undefined }) {
  return (
    <svg viewBox="-50 -50 100 100" aria-hidden="true" fill="none" stroke="currentColor">
      {(thumb?.ring ?? true) && <circle r="42" stroke-width="1.2" opacity="0.5" />}
      {thumb?.path && <path d={thumb.path} stroke-width={thumb.path.length > 4000 ? 0.8 : 2} stroke-linejoin="round" />}
      {thumb?.lines.map((line) => (
        <path key={line.d} d={line.d} opacity={line.opacity} stroke-width={line.width} />
      ))}
    </svg>
  );
}
