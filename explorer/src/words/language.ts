/** Which language is spoken: the browser's at first, then the one that somebody picked. */

import { computed, signal } from "@preact/signals";
import type { Language } from "../numbers/spell";
import { de } from "./de";
import { en, type Words } from "./en";
import { presetsDe, presetsEn } from "./presets";
import { browserLanguage } from "./say";

export { fill } from "./say";

const DICTIONARIES: Record<Language, Words> = { de, en };

export const language = signal<Language>(browserLanguage(navigator.languages));
export const words = computed(() => DICTIONARIES[language.value]);
export const presetWords = computed(() => (language.value === "de" ? presetsDe : presetsEn));
