/** A quantity of the sentence: blue and dotted, since one may change it. */

import { useRef } from "preact/hooks";
import { quantityOf, type QuantityKey } from "../state/quantities";
import { ruling } from "../state/page";
import { redraw } from "../state/loop";
import { language, words } from "../words/language";
import { clamped, moved, stepped } from "./scale";

interface Props {
  readonly name: QuantityKey;
  /** What stands in the sentence where it is not the number, such as the name of a body. */
  readonly text?: string;
}

/** px after which a press is a drag. */
const DRAG = 5;

export function QuantityButton({ name, text }: Props) {
  const drag = useRef<{ x: number; from: number; moved: boolean } | null>(null);
  const quantity = quantityOf(name, words.value, language.value);
  if (!quantity) return null;
  const set = (value: number): void => {
    quantity.set(clamped(quantity, value));
    redraw();
  };
  const open = ruling.value === name;
  return (
    <button
      type="button"
      id={`quantity-${name}`}
      class="quantity"
      aria-expanded={open}
      aria-controls={open ? "ruler" : undefined}
      aria-label={`${quantity.label}: ${text ? `${text}, ` : ""}${quantity.spell(quantity.value)}`}
      onClick={() => {
        if (!drag.current?.moved) ruling.value = open ? null : name;
        drag.current = null;
      }}
      onKeyDown={(event) => {
        const next = stepped(quantity, event);
        if (next === null) return;
        event.preventDefault();
        set(next);
      }}
      onPointerDown={(event) => {
        if (event.pointerType === "touch" || event.button !== 0) return;
        drag.current = { x: event.clientX, from: quantity.value, moved: false };
        event.currentTarget.setPointerCapture(event.pointerId);
      }}
      onPointerMove={(event) => {
        const held = drag.current;
        if (!held || !event.currentTarget.hasPointerCapture(event.pointerId)) return;
        const way = event.clientX - held.x;
        if (!held.moved && Math.abs(way) < DRAG) return;
        held.moved = true;
        set(moved(quantity, held.from, way));
      }}
    >
      {text ?? quantity.spell(quantity.value)}
    </button>
  );
}
