import { loadCore } from "./core";

await loadCore();
