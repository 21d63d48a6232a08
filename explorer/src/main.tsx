/** Starts the page: words at once, the motion as soon as the core is there. */

import { effect } from "@preact/signals";
import { render } from "preact";
import { loadCore } from "./core";
import { App } from "./page/App";
import { keepKiosk } from "./page/kiosk";
import { togglePlay } from "./instruments/TimeBar";
import { released } from "./stage/grip";
import { remember, take } from "./state/address";
import { redraw } from "./state/loop";
import { beside, core, dark, duration, given, gripped, kiosk, launches, playing, preset, reducedMotion, rod, systemDark } from "./state/page";
import { de } from "./words/de";
import { en, type Words } from "./words/en";
import { language, presetWords, words } from "./words/language";
import "./style/tokens.css";
import "./style/page.css";
import "./style/text.css";
import "./style/stage.css";
import "./style/time.css";
import "./style/foucault.css";

const root = document.documentElement;
const prefersDark = matchMedia("(prefers-color-scheme: dark)");
const prefersLess = matchMedia("(prefers-reduced-motion: reduce)");

systemDark.value = prefersDark.matches;
prefersDark.addEventListener("change", () => (systemDark.value = prefersDark.matches));
reducedMotion.value = prefersLess.matches;
prefersLess.addEventListener("change", () => (reducedMotion.value = prefersLess.matches));

effect(() => {
  root.dataset["theme"] = dark.value ? "dark" : "light";
});
effect(() => {
  root.toggleAttribute("data-kiosk", kiosk.value);
});
// The page's head has looked into the link already.
if (root.dataset["tongue"] === "de" || root.dataset["tongue"] === "en") language.value = root.dataset["tongue"];
effect(() => {
  root.lang = root.dataset["tongue"] = language.value;
  document.title = `${preset.value ? presetWords.value[preset.value].title : words.value.gallery.own} · ${words.value.name}`;
});

/** Space plays and pauses where nothing else has the focus. */
window.addEventListener("keydown", (event) => {
  if (event.key !== " " || event.target !== document.body) return;
  event.preventDefault();
  togglePlay();
});
document.addEventListener("visibilitychange", redraw);

/** How long the core may load before it is said to, ms. */
const PATIENCE = 1000;

const page = document.getElementById("page") as HTMLElement;

/** Says something on the page as it is until the core is there; both languages stand in it, and one of them is seen. */
function hint(text: (words: Words) => string): void {
  for (const [tongue, say] of Object.entries({ de, en })) {
    const place = page.querySelector<HTMLElement>(`.first .hint[lang=${tongue}]`);
    if (!place) continue;
    place.textContent = text(say);
    place.hidden = false;
  }
}

async function start(): Promise<void> {
  const loading = setTimeout(() => hint((say) => say.stage.loading), PATIENCE);
  try {
    core.value = await loadCore();
  } catch {
    // Without WebAssembly, without SIMD, or where the file does not come. The drawing, what it shows and the way to the
    // derivation stay.
    hint((say) => say.stage.failed);
    return;
  } finally {
    clearTimeout(loading);
  }
  take(location.hash);
  page.replaceChildren();
  render(<App />, page);
  playing.value = !reducedMotion.value;
  redraw();
  let steps = released.value;
  effect(() => {
    void [launches.value, given.value, duration.value, language.value, beside.value, rod.value, gripped.value, kiosk.value];
    remember(released.value !== steps);
    steps = released.value;
  });
  keepKiosk();
  window.addEventListener("popstate", () => {
    take(location.hash);
    redraw();
  });
  void document.fonts.load("600 12px Inter").then(redraw);
  root.dataset["ready"] = "";
}

void start();
