import { readFileSync } from "node:fs";
import preact from "@preact/preset-vite";
import { defineConfig } from "vite";
import { first } from "./build/first";
import { sentences } from "./build/sentences";
import { startCore } from "./src/core";

// The core is asked while the page is built, too: what it may refuse, and what it says of the first example.
const core = await startCore(readFileSync(new URL("./src/core/kugelpendel.wasm", import.meta.url)));

// Addresses are relative, so that the page works below any path and from any static host. The engine, which is the core
// and the links, is a file of its own with a name that stays, so that the tests ask what the page asks.
export default defineConfig({
  base: "./",
  plugins: [preact(), sentences(core.refusalKinds), first(core)],
  build: {
    target: "es2022",
    outDir: "../src/kugelpendel/cli/explore/page",
    emptyOutDir: true,
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 1024,
    rolldownOptions: {
      input: { index: "index.html", engine: "src/engine.ts" },
      preserveEntrySignatures: "exports-only",
      output: { entryFileNames: (chunk) => (chunk.name === "engine" ? "engine.js" : "assets/[name]-[hash].js") },
    },
  },
});
