/** What the page stands on, without anything that is seen. */
export * from "./core";
export * from "./job";
export { refusal } from "./words/sentences";
