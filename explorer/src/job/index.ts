/** A state of the page as a link and as a job file, with the keys of job files. */
import type { Given } from "../core";

export interface PageState {
  readonly given: Given;
  /** s; how long a job file saved from here runs */
  readonly duration: number;
  /** What is seen beside it; keys that job files do not have. */
  readonly view: View;
}

export interface View {
  /** Laws that are drawn beside the bob: "cubic", "ellipse", "linear". */
  readonly beside?: readonly ("cubic" | "ellipse" | "linear")[];
  /** Whether the support is a rod. */
  readonly rod?: boolean;
  readonly kiosk?: boolean;
  readonly language?: "de" | "en";
  /** Name of the preset that it came from; only [a-z]. */
  readonly preset?: string;
}

/** Of a fragment: the state, or null where it is not one; `garbled` where anything in it was not understood. */
export interface Read {
  readonly state: PageState | null;
  readonly garbled: boolean;
}
