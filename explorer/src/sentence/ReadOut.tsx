/** A number that follows, and what it means on a tap. */

import type { ComponentChildren } from "preact";
import { useRef, useState } from "preact/hooks";
import { kiosk } from "../state/page";
import { fill, language, words } from "../words/language";
import { Filled } from "./Filled";
import { Popover } from "../page/Popover";

interface Props {
  readonly value: string;
  readonly title: string;
  readonly text: string;
  /** All its digits. */
  readonly full?: string | undefined;
  /** Number of the equation in the derivation that it comes from. */
  readonly equation?: string | undefined;
  readonly big?: boolean;
  readonly className?: string;
  readonly more?: ComponentChildren;
}

/** Where a numbered equation stands in the derivation that lies beside this page. */
export function derivation(equation?: string): string {
  return `derivation.${language.value}.html${equation ? `#eq-${equation}` : ""}`;
}

export function ReadOut({ value, title, text, full, equation, big, className, more }: Props) {
  const [open, setOpen] = useState(false);
  const button = useRef<HTMLButtonElement>(null);
  const say = words.value.explain;
  return (
    <>
      <button
        ref={button}
        type="button"
        class={className ?? (big ? "read-out big" : "read-out")}
        aria-haspopup="dialog"
        aria-expanded={open}
        onClick={() => setOpen(!open)}
      >
        {value}
      </button>
      {open && button.current && (
        <Popover anchor={button.current} label={title} kind="popover" close={() => setOpen(false)}>
          <h2>{title}</h2>
          <p>{text}</p>
          {full && <p>{fill(say.full, { value: full })}</p>}
          {more}
          {equation && !kiosk.value && (
            <p>
              <a href={derivation(equation)} target="_blank" rel="noopener">
                <Filled text={say.link} holes={{ number: `(${equation})` }} />
              </a>
            </p>
          )}
        </Popover>
      )}
    </>
  );
}
