/** The page as it is before its program runs, and without one: what the first example is, in both languages, and its rosette. */

import type { Plugin } from "vite";
import type { Core } from "../src/core";
import { Camera, FLOOR, floorRadius, type Point } from "../src/drawing/camera";
import { BOB_RADIUS, placed } from "../src/drawing/scene";
import { percent, quantity, rate, time, type Language } from "../src/numbers/spell";
import { handOf } from "../src/state/hand";
import { PRESETS } from "../src/state/presets";
import { de } from "../src/words/de";
import { en } from "../src/words/en";
import { browserLanguage, fill } from "../src/words/say";
import { presetsDe, presetsEn } from "../src/words/presets";

const LANGUAGES = ["en", "de"] as const;
const WORDS = { de, en } as const;
const TITLES = { de: presetsDe.rosette, en: presetsEn.rosette } as const;

/** Half a turn of the first example, s: then its rosette is whole. And points of it. */
const SHOWN = 36.4;
const POINTS = 620;

/** Size of the drawing, and room around it, as on the stage. */
const SIZE = 1000;
const ROOM = 34;

/** Before anything is seen, the browser's language and its light or dark; a link may say another language. */
const EARLY = `(() => {
const root = document.documentElement;
const [, said] = /[#&]lang=(de|en)(?:&|$)/.exec(location.hash) ?? [];
root.lang = root.dataset.tongue = said ?? (${String(browserLanguage)})(navigator.languages);
if (matchMedia("(prefers-color-scheme: dark)").matches) root.dataset.theme = "dark";
})()`;

/** What stands in the page until its program draws it. */
export function firstPage(core: Core): string {
  const text = LANGUAGES.map((language) => `<div lang="${language}">${said(core, language)}</div>`).join("");
  const hints = LANGUAGES.map((language) => `<p class="hint" lang="${language}" role="status" hidden></p>`).join("");
  return (
    `<div class="page first"><header><div class="brand">${MARK}<span>${en.name}</span></div></header>` +
    `<main class="text">${text}</main><div class="stage">${rosette(core)}${hints}</div></div>`
  );
}

function said(core: Core, language: Language): string {
  const say = WORDS[language];
  const { title, text } = TITLES[language];
  const { given } = PRESETS.rosette;
  const motion = core.motion(given, "exact");
  const state = motion.state(0);
  motion.free();
  if (!state) throw new Error("The first example does not start.");
  const { pull, across } = handOf(state);
  const summary = core.summary(given);
  const { formula25, error25 } = summary;
  if (formula25 === null || error25 === null) throw new Error("Formula (25) does not apply to the first example.");
  const number = (text: string): string => `<strong>${text}</strong>`;
  const si = (value: number, unit: "m" | "m/s" | "s", digits: number): string => number(quantity(value, unit, digits, language));
  const start = fill(say.given.free, {
    length: si(given.pendulum.length, "m", 3),
    wire: say.given.thread,
    place: fill(say.given.earth, { gravity: number(say.bodies.earth) }),
    pull: si(pull, "m", 3),
    push: si(across, "m/s", 3),
  });
  const follows = fill(say.follows.ellipse, {
    period: si(summary.swingPeriod, "s", 4),
    rate: number(rate(summary.turning, 3, language)),
    turn: number(time(summary.fullTurn, 3, language)),
  });
  const formula = fill(error25 < 0 ? say.follows.less : say.follows.more, {
    number: "(25)",
    rate: number(rate(formula25, 3, language)),
    error: number(percent(error25, language)),
  });
  return (
    `<h1 class="title">${title}</h1><p class="preset-text">${text}</p><p class="sentence">${start}</p><hr class="rule">` +
    `<p class="sentence">${follows}</p>` +
    `<p class="note formula-note">${formula} <a href="derivation.${language}.html#eq-25">${say.follows.source}</a></p>` +
    `<noscript><p class="note">${say.first.needs}</p></noscript>`
  );
}

const MARK =
  '<svg viewBox="0 0 32 32" aria-hidden="true"><path d="M9 5h14M17 5l-4 18" fill="none" stroke="currentColor" stroke-width="2"/>' +
  '<ellipse cx="17" cy="24" rx="13" ry="4" transform="rotate(-6 17 24)" fill="none" stroke="var(--accent)" stroke-width="2"/>' +
  '<circle cx="12" cy="23" r="4.6" fill="var(--brass)" stroke="var(--brass-dark)" stroke-width=".8"/></svg>';

/** The pendulum over its rosette, from where the stage sees it. */
function rosette(core: Core): string {
  const { given } = PRESETS.rosette;
  const { length } = given.pendulum;
  const radius = floorRadius(core.summary(given).outer / length);
  const camera = new Camera();
  camera.fit({ left: ROOM, top: ROOM, width: SIZE - 2 * ROOM, height: SIZE - 2 * ROOM }, radius, false);
  const motion = core.motion(given, "exact");
  const way = motion.positions(Float64Array.from({ length: POINTS }, (_, index) => (SHOWN * index) / (POINTS - 1)));
  motion.free();
  const points = Array.from({ length: POINTS }, (_, index): Point => {
    const [x = 0, y = 0, z = 0] = way.subarray(3 * index, 3 * index + 3);
    return placed(x / length, y / length, 1 - z / length, 1);
  });
  const rim = Array.from({ length: 60 }, (_, step): Point => {
    const angle = (step / 60) * 2 * Math.PI;
    return [radius * Math.cos(angle), radius * Math.sin(angle), FLOOR];
  });
  const last = points.at(-1) as Point;
  const [support, bob] = [camera.project([0, 0, 0]), camera.project(last)];
  const shadow = points.map(([x, y]): Point => [x, y, FLOOR]);
  const [sx, sy] = [Math.round(support.x), Math.round(support.y)];
  return (
    `<svg viewBox="0 0 ${SIZE} ${SIZE}" aria-hidden="true" fill="none" stroke-linejoin="round">` +
    '<defs><radialGradient id="brass" cx=".36" cy=".32" r=".75"><stop stop-color="var(--brass-light)"/>' +
    '<stop offset=".5" stop-color="var(--brass)"/><stop offset="1" stop-color="var(--brass-dark)"/></radialGradient></defs>' +
    `<path d="${line(camera, rim, 1)}z" fill="var(--floor)" stroke="var(--floor-ink)"/>` +
    `<path d="${line(camera, shadow, 3)}" stroke="var(--ink)" opacity=".12"/>` +
    `<path d="${line(camera, points, 1)}" stroke="var(--exact)" stroke-width="2" opacity=".75"/>` +
    `<path d="M${sx - 45} ${sy}h90M${sx} ${sy}L${bob.x.toFixed(0)} ${bob.y.toFixed(0)}" stroke="var(--ink)" stroke-width="2"/>` +
    `<circle cx="${bob.x.toFixed(0)}" cy="${bob.y.toFixed(0)}" r="${(BOB_RADIUS * bob.scale).toFixed(0)}" fill="url(#brass)"/></svg>`
  );
}

/** A line through every so manieth of the points, each said by how far it lies from the one before. */
function line(camera: Camera, points: readonly Point[], every: number): string {
  let [beforeX, beforeY, found] = [0, 0, ""];
  points.forEach((point, index) => {
    if (index % every !== 0) return;
    const at = camera.project(point);
    const [x, y] = [Math.round(at.x), Math.round(at.y)];
    const [dx, dy] = [x - beforeX, y - beforeY];
    found += index === 0 ? `M${x} ${y}l` : `${dx < 0 || found.endsWith("l") ? "" : " "}${dx}${dy < 0 ? "" : " "}${dy}`;
    [beforeX, beforeY] = [x, y];
  });
  return found;
}

/** Puts that page into index.html, and lets the browser fetch the core and the fonts while it reads the program. */
export function first(core: Core): Plugin {
  return {
    name: "first",
    transformIndexHtml: {
      order: "post",
      handler: (html, { bundle }) => ({
        html: html.replace('<div id="page"></div>', () => `<div id="page">${firstPage(core)}</div>`),
        tags: [
          { tag: "script", children: EARLY, injectTo: "head" as const },
          ...Object.keys(bundle ?? {}).flatMap((file) => {
            const kind = file.endsWith(".wasm") ? "fetch" : file.endsWith(".woff2") ? "font" : null;
            return kind ? [{ tag: "link", attrs: { rel: "preload", as: kind, href: `./${file}`, crossorigin: true }, injectTo: "head" as const }] : [];
          }),
        ],
      }),
    },
  };
}
