/** What opens beside something that was tapped: Escape or a tap elsewhere closes it, and the focus goes back. */

import type { ComponentChildren } from "preact";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";

interface Props {
  readonly anchor: HTMLElement;
  readonly label: string;
  readonly kind: "popover" | "menu";
  readonly close: () => void;
  readonly children: ComponentChildren;
}

export function Popover({ anchor, label, kind, close, children }: Props) {
  const box = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    const element = box.current;
    if (!element) return;
    const at = anchor.getBoundingClientRect();
    const { width, height } = element.getBoundingClientRect();
    const below = at.bottom + 8 + height <= window.innerHeight;
    element.style.left = `${Math.max(12, Math.min(at.left, window.innerWidth - width - 12))}px`;
    element.style.top = `${below ? at.bottom + 8 : Math.max(8, at.top - height - 8)}px`;
    element.focus();
  }, [anchor]);
  useEffect(() => {
    const leave = (): void => {
      close();
      anchor.focus();
    };
    const onKey = (event: KeyboardEvent): void => {
      if (event.key !== "Escape") return;
      event.stopPropagation();
      leave();
    };
    const onPointer = (event: PointerEvent): void => {
      const target = event.target as Node;
      if (!box.current?.contains(target) && !anchor.contains(target)) close();
    };
    window.addEventListener("keydown", onKey, true);
    window.addEventListener("pointerdown", onPointer, true);
    return () => {
      window.removeEventListener("keydown", onKey, true);
      window.removeEventListener("pointerdown", onPointer, true);
    };
  }, [anchor, close]);
  return (
    <div ref={box} class={kind} role="dialog" aria-label={label} tabIndex={-1}>
      {children}
    </div>
  );
}
