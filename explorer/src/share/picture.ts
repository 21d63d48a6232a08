/** The stage as a picture, with the sentences and numbers that belong to it. */

import { readInk } from "../drawing/ink";
import { moment } from "../numbers/spell";
import { clock, duration, preset } from "../state/page";
import { language, presetWords, words } from "../words/language";

const WIDTH = 1600;
const HEIGHT = 1000;
const MARGIN = 56;
const TEXT = 620;

/** What a section says, as plain text; numbers and controls are words of it. */
function said(selector: string): string {
  return (document.querySelector(selector)?.textContent ?? "").replaceAll(/\s+/g, " ").trim();
}

export async function picture(): Promise<Blob | null> {
  const ink = readInk(document.documentElement);
  await document.fonts.ready;
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [WIDTH, HEIGHT];
  const context = canvas.getContext("2d");
  if (!context) return null;
  context.fillStyle = ink.color.paper;
  context.fillRect(0, 0, WIDTH, HEIGHT);
  drawLayers(context);
  const style = getComputedStyle(document.documentElement);
  const serif = style.getPropertyValue("--serif");
  let y = MARGIN + 44;
  const write = (text: string, font: string, pitch: number, color: string): void => {
    context.font = font;
    context.fillStyle = color;
    for (const line of lines(context, text, TEXT)) {
      context.fillText(line, MARGIN, y);
      y += pitch;
    }
    y += 0.5 * pitch;
  };
  write(preset.value ? presetWords.value[preset.value].title : words.value.gallery.own, `600 46px ${serif}`, 52, ink.color.ink);
  for (const selector of [".sentence.given", ".sentence.follows", ".formula-note"]) {
    const note = selector === ".formula-note";
    const text = said(selector).replace(words.value.follows.source, "").trim();
    if (text) write(text, note ? `500 20px ${ink.sans}` : `400 27px ${serif}`, note ? 30 : 40, note ? ink.color.soft : ink.color.ink);
  }
  context.font = `500 20px ${ink.sans}`;
  context.fillStyle = ink.color.soft;
  context.fillText(`t = ${moment(clock.time, duration.value, language.value)} · ${words.value.name}`, MARGIN, HEIGHT - MARGIN);
  const note = said(".stage-note");
  lines(context, note, WIDTH - TEXT - 3 * MARGIN).forEach((line, index) => context.fillText(line, TEXT + 2 * MARGIN, HEIGHT - MARGIN + 28 * index - 28));
  return new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
}

/** The layers of the stage, one over the other, as large as there is room. */
function drawLayers(context: CanvasRenderingContext2D): void {
  const [left, top] = [TEXT + 1.5 * MARGIN, MARGIN];
  for (const layer of document.querySelectorAll<HTMLCanvasElement>(".stage canvas:not([hidden])")) {
    const share = Math.min((WIDTH - left - MARGIN) / layer.width, (HEIGHT - 3 * MARGIN - top) / layer.height);
    context.drawImage(layer, left, top, layer.width * share, layer.height * share);
  }
}

function lines(context: CanvasRenderingContext2D, text: string, width: number): string[] {
  const found: string[] = [];
  let line = "";
  for (const word of text.split(" ")) {
    const longer = line ? `${line} ${word}` : word;
    if (line && context.measureText(longer).width > width) {
      found.push(line);
      line = word;
    } else line = longer;
  }
  return line ? [...found, line] : found;
}
