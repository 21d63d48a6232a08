/** A state of the page as a link and as a job file, with the keys of job files. */
export { writeJobFile } from "./file";
export { LAUNCHES, TABLES } from "./keys";
export { readLink, writeLink, type Beside, type Link, type ReadLink, type View } from "./link";
export type { Kind } from "./keys";
export { readQuantity, writeQuantity } from "./quantity";
