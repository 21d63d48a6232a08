/** The sentences of the core's refusals, out of the files from which Python says them as well. */

import { parse } from "smol-toml";
import type { Plugin } from "vite";
import type { Sentences } from "../src/words/sentences";

interface Entry {
  readonly python: string;
  /** For who has to do with job files, where that is another sentence. */
  readonly file?: string;
}

interface Tables {
  readonly launch: string;
  readonly unnamed: string;
  readonly quantities: Readonly<Record<string, Entry & { readonly name: string }>>;
  readonly kinds: Readonly<Record<string, Entry>>;
}

/** Of a file, what the page may have to say: the kinds of the core, as they are told to who writes a job file. */
export function sentencesOf(text: string, kinds: readonly string[]): Sentences {
  const tables = parse(text) as unknown as Tables;
  const said = ({ python, file }: Entry): string => file ?? python;
  const quantities = Object.entries(tables.quantities).map(([key, entry]) => [key, { name: entry.name, wayOut: said(entry) }] as const);
  const sentences = kinds.map((kind) => {
    const entry = tables.kinds[kind];
    if (!entry) throw new Error(`There is no sentence for ${kind}.`);
    return [kind, said(entry)] as const;
  });
  return { launch: tables.launch, unnamed: tables.unnamed, quantities: Object.fromEntries(quantities), kinds: Object.fromEntries(sentences) };
}

/** Lets a module import such a file. */
export function sentences(kinds: readonly string[]): Plugin {
  return {
    name: "sentences",
    transform: {
      filter: { id: /\.toml$/ },
      handler: (text) => ({ code: `export default ${JSON.stringify(sentencesOf(text, kinds))}`, moduleType: "js", map: null }),
    },
  };
}
