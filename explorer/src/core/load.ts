import type { Core } from "./core";

/** Fetches the core and starts it; rejects where the browser cannot run it. */
export async function loadCore(): Promise<Core> {
  const response = await fetch(new URL("./kugelpendel.wasm", import.meta.url));
  await WebAssembly.instantiateStreaming(response, {});
  throw new Error("The core does not answer yet.");
}
