/** The colours of the page as the drawings use them, read from its style sheet. */

const NAMES = [
  "ink",
  "soft",
  "paper",
  "raised",
  "line",
  "edge",
  "accent",
  "wash",
  "exact",
  "cubic",
  "ellipse",
  "linear",
  "stall",
  "brass-light",
  "brass",
  "brass-dark",
  "floor",
  "floor-edge",
  "floor-side",
  "floor-ink",
  "sea",
  "land",
] as const;

export type InkName = (typeof NAMES)[number];

export interface Ink {
  readonly color: Readonly<Record<InkName, string>>;
  /** Opacity of the oldest part of a trace. */
  readonly oldest: number;
  /** By how much all lines are wider than on a screen that one sits at. */
  readonly weight: number;
  readonly sans: string;
  readonly chartSize: number;
}

export function readInk(root: HTMLElement): Ink {
  const style = getComputedStyle(root);
  const read = (name: string): string => style.getPropertyValue(`--${name}`).trim();
  const color = Object.fromEntries(NAMES.map((name) => [name, read(name)])) as Record<InkName, string>;
  return {
    color,
    oldest: Number(read("oldest")) || 0.22,
    weight: Number(read("weight")) || 1,
    sans: read("sans") || "sans-serif",
    chartSize: Number.parseFloat(read("chart-size")) || 12,
  };
}

/** A colour of the style sheet with an opacity, for canvases. */
export function faded(color: string, alpha: number): string {
  const [red, green, blue] = channels(color);
  return `rgb(${red} ${green} ${blue} / ${alpha})`;
}

/** Red, green and blue from 0 to 255 of a colour that is written #rrggbb, or shortened to #rgb. */
export function channels(color: string): readonly [number, number, number] {
  const digits = color.length < 7 ? color.replace(/[0-9a-f]/gi, "$&$&") : color;
  const value = Number.parseInt(digits.slice(1, 7), 16);
  return [(value >> 16) & 255, (value >> 8) & 255, value & 255];
}
