/** The ruler under the sentence: a scale under a fixed pointer, famous values, and a field to type in. */

import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import { faded, readInk, type Ink } from "../drawing/ink";
import { readTyped } from "../numbers/read";
import { oneIn, plain } from "../numbers/spell";
import { unitFor, type Si } from "../numbers/ladders";
import { dark, kiosk, reducedMotion, refused, refusedGiven, relaunch, ruling } from "../state/page";
import { redraw } from "../state/loop";
import { quantityOf, type Quantity, type QuantityKey } from "../state/quantities";
import { fill, language, words } from "../words/language";
import { refusal } from "../words/sentences";
import { clamped, ends, glide, marks, moved, stepped, type Sample } from "./scale";

export function Ruler() {
  const name = ruling.value as QuantityKey | null;
  const quantity = name && quantityOf(name, words.value, language.value);
  if (!quantity) return null;
  return <Opened key={name} quantity={quantity} />;
}

function Opened({ quantity }: { readonly quantity: Quantity }) {
  // Said anew with each language.
  const [problem, setProblem] = useState<(() => string) | null>(null);
  const [text, setText] = useState("");
  const say = words.value.ruler;
  const complain = (sentence: (() => string) | null): void => setProblem(() => sentence);
  const set = (value: number, exact = false): void => {
    const inside = exact ? value : clamped(quantity, value);
    const limit = inside > value ? "least" : "most";
    complain(inside === value ? null : () => fill(words.value.ruler[limit], { value: quantityOf(quantity.key, words.value, language.value)?.spell(inside) ?? "" }));
    const done = quantity.set(inside);
    const why = refused.value;
    if (!done) complain(why && (() => refusal(why, language.value)));
    redraw();
  };
  const typed = (event: Event): void => {
    event.preventDefault();
    const value = quantity.si === "ratio" ? readRatio(text) : readTyped(text, quantity.si);
    if (value === undefined) complain(() => words.value.ruler.unreadable[quantity.si]);
    else {
      set(value);
      setText("");
    }
  };
  return (
    <div class="ruler" id="ruler">
      <Scale quantity={quantity} set={set} />
      <div class="chips">
        {quantity.chips.map((chip) => (
          <button key={chip.text} type="button" class="chip" aria-pressed={Math.abs(chip.value - quantity.value) <= 1e-9 * Math.abs(chip.value)} onClick={() => set(chip.value, true)}>
            {chip.text}
          </button>
        ))}
      </div>
      {!kiosk.value && (
        <form onSubmit={typed}>
          <input aria-label={`${say.type}: ${quantity.label}`} placeholder={quantity.spell(quantity.value)} value={text} autoComplete="off" onInput={(event) => setText(event.currentTarget.value)} />
          <button type="submit" class="chip">
            OK
          </button>
        </form>
      )}
      <p class="refusal" role="status">
        {problem?.()}
      </p>
      <Weaker done={() => complain(null)} />
    </div>
  );
}

/** The way out where a drive gives more than the drag takes: the push that keeps the swing as it is. */
function Weaker({ done }: { readonly done: () => void }) {
  const [why, wanted] = [refused.value, refusedGiven.value];
  const keeps = why?.seen.find(({ name }) => name === "keeps")?.value;
  const drive = wanted?.drive;
  if (!wanted || !drive || keeps === undefined) return null;
  return (
    <button
      type="button"
      class="chip"
      onClick={() => {
        relaunch({ ...wanted, drive: { ...drive, push: keeps } });
        done();
        redraw();
      }}
    >
      {words.value.notice.weakerChip}
    </button>
  );
}

/** "1 : 100 000", "1e-5". */
function readRatio(text: string): number | undefined {
  const parts = text.replaceAll(/[\s\u202f\u00a0]/g, "").split(":");
  const numbers = parts.map((part) => Number(parts.length > 1 ? part.replaceAll(/[.,]/g, "") : part.replace(",", ".")));
  const value = numbers.length === 2 ? (numbers[0] ?? 0) / (numbers[1] ?? 0) : (numbers[0] ?? Number.NaN);
  return parts.length <= 2 && Number.isFinite(value) && value >= 0 ? value : undefined;
}

function Scale({ quantity, set }: { readonly quantity: Quantity; readonly set: (value: number) => void }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const held = useRef<{ x: number; from: number; way: Sample[] } | null>(null);
  const gliding = useRef(0);
  const stop = (): void => cancelAnimationFrame(gliding.current);
  useEffect(() => stop, []);
  useLayoutEffect(() => canvas.current?.focus({ preventScroll: true }), []);
  useEffect(() => {
    if (canvas.current) drawScale(canvas.current, quantity);
  }, [quantity.value, quantity.least, quantity.most, language.value, dark.value]);
  return (
    <canvas
      ref={canvas}
      role="slider"
      tabIndex={0}
      aria-label={quantity.label}
      aria-valuemin={quantity.least}
      aria-valuemax={quantity.most}
      aria-valuenow={Number.isFinite(quantity.value) ? quantity.value : quantity.most}
      aria-valuetext={quantity.spell(quantity.value)}
      onKeyDown={(event) => {
        if (event.key === "Escape") {
          ruling.value = null;
          document.getElementById(`quantity-${quantity.key}`)?.focus();
        }
        const next = stepped(quantity, event);
        if (next === null) return;
        event.preventDefault();
        set(next);
      }}
      onPointerDown={(event) => {
        stop();
        held.current = { x: event.clientX, from: quantity.value, way: [{ x: event.clientX, time: event.timeStamp }] };
        event.currentTarget.setPointerCapture(event.pointerId);
      }}
      onPointerMove={(event) => {
        // The scale goes with the hand, so that the value under the pointer goes the other way.
        if (!held.current || !event.buttons) return;
        held.current.way.push({ x: event.clientX, time: event.timeStamp });
        set(moved(quantity, held.current.from, held.current.x - event.clientX));
      }}
      onPointerUp={(event) => {
        const was = held.current;
        held.current = null;
        if (!was || reducedMotion.value) return;
        const further = glide(was.way, event.timeStamp);
        if (further.whole === 0) return;
        const began = performance.now();
        const step = (): void => {
          const { px, done } = further.at(performance.now() - began);
          set(moved(quantity, was.from, was.x - event.clientX - px));
          if (!done) gliding.current = requestAnimationFrame(step);
        };
        gliding.current = requestAnimationFrame(step);
      }}
      onPointerCancel={() => (held.current = null)}
    />
  );
}

function figure(quantity: Quantity, value: number): string {
  if (quantity.si === "ratio") return oneIn(value, language.value);
  const unit = unitFor(value, quantity.si as Si);
  return `${plain(value / unit.size, 3, language.value)}${unit.symbol === "°" ? "" : "\u00a0"}${unit.symbol}`;
}

function drawScale(canvas: HTMLCanvasElement, quantity: Quantity): void {
  const ink = readInk(document.documentElement);
  const { width, height } = canvas.getBoundingClientRect();
  const density = window.devicePixelRatio;
  [canvas.width, canvas.height] = [Math.round(width * density), Math.round(height * density)];
  const context = canvas.getContext("2d") as CanvasRenderingContext2D;
  context.scale(density, density);
  const middle = Math.min(Math.max(quantity.value, quantity.least), quantity.most);
  const dense = marks(quantity, middle, width / 2 + 40);
  for (const [from, to] of ends(quantity, middle, width / 2)) drawEnd(context, ink, width / 2 + from, width / 2 + to, height);
  let free = Number.NEGATIVE_INFINITY;
  context.textAlign = "center";
  context.font = `500 ${ink.chartSize}px ${ink.sans}`;
  for (const { at, value, rank } of dense) {
    const x = width / 2 + at;
    context.strokeStyle = faded(ink.color.ink, rank === 2 ? 0.9 : rank === 1 ? 0.55 : 0.3);
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(x, 0);
    context.lineTo(x, rank === 2 ? 28 : rank === 1 ? 18 : 11);
    context.stroke();
    if (rank !== 2) continue;
    const text = figure(quantity, value);
    const half = context.measureText(text).width / 2;
    if (x - half < free) continue;
    free = x + half + 10;
    context.fillStyle = ink.color.ink;
    context.fillText(text, x, 52);
  }
  context.fillStyle = ink.color.accent;
  context.beginPath();
  context.moveTo(width / 2 - 8, 0);
  context.lineTo(width / 2 + 8, 0);
  context.lineTo(width / 2, 9);
  context.fill();
  context.fillRect(width / 2 - 1, 0, 2, 32);
}

/** px between the lines of a hatched end. */
const HATCH = 8;

/** Beyond its least and its most value the scale is hatched. */
function drawEnd(context: CanvasRenderingContext2D, ink: Ink, from: number, to: number, height: number): void {
  context.save();
  context.beginPath();
  context.rect(from, 0, to - from, height);
  context.clip();
  context.strokeStyle = faded(ink.color.ink, 0.3);
  context.lineWidth = 1;
  context.beginPath();
  for (let x = HATCH * Math.floor((from - height) / HATCH); x < to; x += HATCH) {
    context.moveTo(x, height);
    context.lineTo(x + height, 0);
  }
  context.stroke();
  context.restore();
}
