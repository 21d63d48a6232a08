/** The core as the page sees it: the Rust core in WebAssembly, typed. */
export * from "./core";
export * from "./given";
export { loadCore, startCore } from "./load";
