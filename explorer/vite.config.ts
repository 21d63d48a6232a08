import preact from "@preact/preset-vite";
import { defineConfig } from "vite";

// Addresses are relative, so that the page works below any path and from any static host.
export default defineConfig({
  base: "./",
  plugins: [preact()],
  build: { target: "es2022", outDir: "dist", assetsInlineLimit: 0, chunkSizeWarningLimit: 1024 },
});
