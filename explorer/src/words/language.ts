/** Which language is spoken: the browser's at first, then the one that somebody picked. */

import { computed, signal } from "@preact/signals";
import type { Language } from "../numbers/spell";
import { de } from "./de";
import { en, type Words } from "./en";
import { presetsDe, presetsEn } from "./presets";

const DICTIONARIES: Record<Language, Words> = { de, en };

export function browserLanguage(languages: readonly string[]): Language {
  for (const one of languages) {
    if (one.toLowerCase().startsWith("de")) return "de";
    if (one.toLowerCase().startsWith("en")) return "en";
  }
  return "en";
}

export const language = signal<Language>(browserLanguage(navigator.languages));
export const words = computed(() => DICTIONARIES[language.value]);
export const presetWords = computed(() => (language.value === "de" ? presetsDe : presetsEn));

/** Puts text into the holes of a sentence, as in "every {time}". */
export function fill(sentence: string, holes: Readonly<Record<string, string>>): string {
  return sentence.replace(/\{(\w+)\}/g, (_, hole: string) => holes[hole] ?? "");
}
