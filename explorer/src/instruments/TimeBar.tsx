/** Time has one place: play, step and speed, and the curve that is the bar to seek in. */

import { useRef } from "preact/hooks";
import { band, drawTimeline, type Curve } from "../drawing/timeline";
import { decimals, moment } from "../numbers/spell";
import { PauseSign, PlaySign, StepSign } from "../page/icons";
import { curvesOf, hasDirection } from "../state/curves";
import { redraw, seek, step } from "../state/loop";
import { averaging, beside, changeSpeed, clock, deviation, duration, launches, live, playing, shownTime, speed, speeds } from "../state/page";
import { nextSpeed, span, times } from "../state/speeds";
import { fill, language, words } from "../words/language";
import { useDrawing } from "./canvas";

export function togglePlay(): void {
  playing.value = !playing.value;
  redraw();
}

export function TimeBar() {
  const say = words.value.time;
  const kind = speed.value === 1 ? say.real : speed.value < 1 ? say.slow : say.lapse;
  const shown = speed.value < 60 ? times(speed.value) : fill(say.second, { span: span(speed.value) });
  return (
    <section class="time" aria-label={say.label}>
      <button type="button" class="play" aria-label={playing.value ? say.pause : say.play} onClick={togglePlay}>
        {playing.value ? <PauseSign /> : <PlaySign />}
      </button>
      <button type="button" class="step" aria-label={say.step} onClick={step}>
        <StepSign />
      </button>
      <div class="speed" role="group" aria-label={say.speed}>
        <button type="button" aria-label={say.slower} disabled={nextSpeed(speeds.value, speed.value, -1) === null} onClick={() => changeSpeed(-1)}>
          −
        </button>
        <output aria-live="polite">{shown}</output>
        <button type="button" aria-label={say.faster} disabled={nextSpeed(speeds.value, speed.value, 1) === null} onClick={() => changeSpeed(1)}>
          +
        </button>
        <span>{kind}</span>
      </div>
      <Chart />
    </section>
  );
}

/** Room for the labels of the curves on the right, px; on a narrow bar there is none. */
function labelRoom(width: number, size: number): number {
  return width > 460 ? 11.2 * size : 0;
}

function Chart() {
  const canvas = useRef<HTMLCanvasElement>(null);
  const bar = useRef<HTMLDivElement>(null);
  const cache = useRef<{ key: readonly unknown[]; curves: readonly Curve[] } | null>(null);
  const area = useRef({ left: 0, right: 1 });

  useDrawing(canvas, (context, ink, width, height) => {
    const now = live.value;
    if (!now) return;
    const key = [now, duration.value, deviation.value, beside.value, ink, language.value];
    if (!cache.current || key.some((one, index) => one !== cache.current?.key[index])) {
      const made = curvesOf({ live: now, end: duration.value, deviation: deviation.value, beside: beside.value, ink, words: words.value, language: language.value });
      cache.current = made.whole ? { key, curves: made.curves } : { key: [], curves: made.curves };
      if (!made.whole) redraw();
    }
    const labels = labelRoom(width, ink.chartSize);
    area.current = band(ink, labels, width, height);
    const ended = (averaging.value ? now.averaged : now.main.motion)?.ended ?? null;
    drawTimeline(
      context,
      {
        ink,
        curves: cache.current.curves,
        now: clock.time,
        end: duration.value,
        flag: moment(clock.time, duration.value, language.value, speed.value < 60),
        labels,
        say: {
          angle: (value, count) => `${decimals((value * 180) / Math.PI, count, language.value)}°`,
          time: (value, unit, count) => `${decimals(value, count, language.value)}\u00a0${unit}`,
        },
        ended: ended ? ended.time : null,
      },
      width,
      height,
    );
  });

  const to = (event: PointerEvent): void => {
    const box = bar.current?.getBoundingClientRect();
    if (!box) return;
    const { left, right } = area.current;
    seek(Math.min(1, Math.max(0, (event.clientX - box.left - left) / (right - left))) * duration.value);
  };
  void launches.value;
  const now = live.value;
  const say = words.value.time;
  const swing = averaging.value ? duration.value / 48 : (now?.period ?? 1);
  const shown = moment(shownTime.value, duration.value, language.value, speed.value < 60);
  return (
    <div class="chart">
      <div class="kinds" role="group" aria-label={say.direction}>
        {([false, true] as const).map((one) => (
          <button key={String(one)} type="button" aria-pressed={deviation.value === one} onClick={() => ((deviation.value = one), redraw())}>
            {one ? say.deviation : now?.mode === "pair" ? say.place : now?.summary.regime === "above" && now.mode === "free" ? say.apex : say.direction}
          </button>
        ))}
      </div>
      <div
        ref={bar}
        class="seek"
        role="slider"
        tabIndex={0}
        aria-label={fill(say.seek, { value: shown })}
        aria-valuemin={0}
        aria-valuemax={duration.value}
        aria-valuenow={Number(shownTime.value.toFixed(1))}
        aria-valuetext={shown}
        onPointerDown={(event) => {
          event.currentTarget.setPointerCapture(event.pointerId);
          to(event);
        }}
        onPointerMove={(event) => {
          if (event.buttons && event.currentTarget.hasPointerCapture(event.pointerId)) to(event);
        }}
        onKeyDown={(event) => {
          const ways: Readonly<Record<string, number>> = { ArrowRight: clock.time + swing, ArrowLeft: clock.time - swing, Home: 0, End: duration.value };
          const next = ways[event.key];
          if (next === undefined) return;
          event.preventDefault();
          seek(next);
        }}
      >
        <canvas ref={canvas} aria-hidden="true" />
      </div>
      {now && !hasDirection(now) && <p class="empty">{say.nothing}</p>}
    </div>
  );
}
