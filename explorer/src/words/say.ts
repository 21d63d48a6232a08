/** How a language is chosen, and how holes of sentences are filled. */

import type { Language } from "../numbers/spell";

/** Stands in the page's head by itself as well, and so needs nothing but what it is given. */
export function browserLanguage(languages: readonly string[]): Language {
  for (const one of languages) {
    if (one.toLowerCase().startsWith("de")) return "de";
    if (one.toLowerCase().startsWith("en")) return "en";
  }
  return "en";
}

/** Puts text into the holes of a sentence, as in "every {time}". */
export function fill(sentence: string, holes: Readonly<Record<string, string>>): string {
  return sentence.replace(/\{(\w+)\}/g, (_, hole: string) => holes[hole] ?? "");
}
