/** A canvas that is as large as its element and drawn with every frame. */

import { effect } from "@preact/signals";
import type { RefObject } from "preact";
import { useLayoutEffect } from "preact/hooks";
import { readInk, type Ink } from "../drawing/ink";
import { onFrame, redraw } from "../state/loop";
import { dark, kiosk, mode } from "../state/page";
import { language } from "../words/language";

export type Draw = (context: CanvasRenderingContext2D, ink: Ink, width: number, height: number) => void;

export function useDrawing(canvas: RefObject<HTMLCanvasElement | null>, draw: Draw): void {
  useLayoutEffect(() => {
    const element = canvas.current;
    const context = element?.getContext("2d");
    if (!element || !context) return undefined;
    let ink = readInk(document.documentElement);
    const size = { width: 0, height: 0 };
    const observer = new ResizeObserver(() => {
      const { width, height } = element.getBoundingClientRect();
      const density = Math.min(window.devicePixelRatio, 2);
      [size.width, size.height] = [width, height];
      [element.width, element.height] = [Math.round(width * density), Math.round(height * density)];
      context.setTransform(density, 0, 0, density, 0, 0);
      redraw();
    });
    observer.observe(element);
    const stopInk = effect(() => {
      void [dark.value, kiosk.value, language.value, mode.value];
      queueMicrotask(() => {
        ink = readInk(document.documentElement);
        redraw();
      });
    });
    const stop = onFrame(() => {
      if (size.width > 0) draw(context, ink, size.width, size.height);
    });
    return () => {
      stop();
      stopInk();
      observer.disconnect();
    };
  }, []);
}
