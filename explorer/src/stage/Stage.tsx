/** The pendulum in space: floor, motion, and what a hand does to it. */

import { effect } from "@preact/signals";
import { useLayoutEffect, useRef, useState } from "preact/hooks";
import { floorRadius, type Pose } from "../drawing/camera";
import { FlatRenderer } from "../drawing/flat";
import { drawFloor } from "../drawing/floor";
import { readInk, type Ink } from "../drawing/ink";
import type { Scene, SceneRenderer } from "../drawing/scene";
import { SpaceRenderer } from "../drawing/space";
import { EARTH } from "../drawing/strokes";
import { DEGREE } from "../numbers/ladders";
import { meetingNow } from "../state/curves";
import { onFrame, redraw } from "../state/loop";
import { averaging, beside, clock, core, dark, given, gripped, kiosk, launches, live, mode, preset } from "../state/page";
import { language, words } from "../words/language";
import { averagedScene } from "./averaged";
import { Handles, placeHandles } from "./Handles";
import { Notes } from "./Notes";
import { drawArrow, drawBearing, drawOver } from "./over";
import { camera, goHome, turn } from "./sight";
import { held, moving } from "./strands";
import { flown, passed, remembered, type Passed } from "./travel";

/** s: so long after a launch in a kiosk the arrow shows the push that the hand gave. */
const ARROW_SHOWN = 1.2;

type Graphics = "space" | "flat" | "lost";

/** From below: floor, what lies on it, the motion by WebGL or flat, and what a hand does. */
type Layers = Readonly<Record<"floor" | "under" | "space" | "flat" | "over", HTMLCanvasElement>>;

export function Stage() {
  const box = useRef<HTMLDivElement>(null);
  const floor = useRef<HTMLCanvasElement>(null);
  const under = useRef<HTMLCanvasElement>(null);
  const space = useRef<HTMLCanvasElement>(null);
  const flat = useRef<HTMLCanvasElement>(null);
  const over = useRef<HTMLCanvasElement>(null);
  const [graphics, setGraphics] = useState<Graphics>("space");

  useLayoutEffect(() => {
    const layers = { floor: floor.current, under: under.current, space: space.current, flat: flat.current, over: over.current };
    if (!box.current || Object.values(layers).some((one) => !one)) return undefined;
    return run(box.current, layers as Layers, setGraphics);
  }, []);

  return (
    <section class="stage" aria-label={words.value.stage.label}>
      <div class="layers" ref={box} data-graphics={graphics}>
        <canvas ref={floor} data-layer="floor" aria-hidden="true" />
        <canvas ref={under} data-layer="under" aria-hidden="true" />
        <canvas ref={space} data-layer="space" aria-hidden="true" hidden={graphics !== "space"} />
        <canvas ref={flat} data-layer="flat" aria-hidden="true" hidden={graphics === "space"} />
        <canvas ref={over} data-layer="over" aria-hidden="true" />
        <Orbit />
        <Handles />
      </div>
      <Notes flat={graphics} />
    </section>
  );
}

/** Draws with every frame from now on; gives back how to stop. */
function run(box: HTMLDivElement, { floor, under, space, flat, over }: Layers, tell: (graphics: Graphics) => void): () => void {
  const plain = new FlatRenderer(flat);
  let renderer: SceneRenderer = plain;
  let deep: SceneRenderer | null = null;
  try {
    deep = new SpaceRenderer(space);
    renderer = deep;
    tell("space");
  } catch {
    tell("flat");
  }
  let ink: Ink = readInk(document.documentElement);
  let stale = true;
  let fitted = "";
  const size = { width: 0, height: 0, density: 1 };

  const measure = (): void => {
    const { width, height } = box.getBoundingClientRect();
    size.width = width;
    size.height = height;
    size.density = Math.min(window.devicePixelRatio, 2);
    for (const one of [floor, under, over]) {
      one.width = Math.round(width * size.density);
      one.height = Math.round(height * size.density);
      one.getContext("2d")?.setTransform(size.density, 0, 0, size.density, 0, 0);
    }
    plain.resize(width, height, size.density);
    deep?.resize(width, height, size.density);
    fitted = "";
    redraw();
  };
  const observer = new ResizeObserver(measure);
  observer.observe(box);
  measure();

  const onLost = (event: Event): void => {
    event.preventDefault();
    renderer = plain;
    tell("lost");
    redraw();
  };
  const onRestored = (): void => {
    if (deep) renderer = deep;
    tell("space");
    redraw();
  };
  space.addEventListener("webglcontextlost", onLost);
  space.addEventListener("webglcontextrestored", onRestored);

  const stopInk = effect(() => {
    void [dark.value, kiosk.value, language.value, mode.value];
    stale = true;
    // The style sheet has the new colours only after the attribute has been set.
    queueMicrotask(() => {
      ink = readInk(document.documentElement);
      stale = true;
      redraw();
    });
  });
  let home: string | null = null;
  /** Where the camera flies to. */
  let flying: Pose | null = null;
  let landing = false;

  const paint = (): void => {
    const now = live.value;
    if (!now || size.width < 100 || size.height < 100) return;
    const view = now.mode === "free" ? "free" : "foucault";
    const way = passed(performance.now());
    if (flying) camera.pose = flying;
    flying = null;
    if (home !== view) goHome((home = view));
    const radius = floorRadius(now.high ? 0 : Math.min(now.reach * now.stretch, 0.6));
    // While it is held, the picture stays under the hand, but for a bob that rises above the support.
    const wanted = `${now.high} ${gripped.value ? fitted.split(" ")[1] : radius} ${camera.elevation} ${camera.azimuth} ${size.width} ${size.height} ${noted(box, size.height)}`;
    if (wanted !== fitted && !(gripped.value && fitted.startsWith("true"))) {
      fitted = wanted;
      camera.fit({ left: 34, top: 10, width: size.width - 68, height: size.height - 34 - noted(box, size.height) }, radius, now.high);
      stale = true;
    }
    let shown = Number(fitted.split(" ")[1]);
    if (way && way.flight < 1) {
      flying = camera.pose;
      flown(camera, way);
      shown = way.floor + way.flight * (shown - way.floor);
      stale = true;
    } else if (landing) stale = true;
    landing = flying !== null;
    if (stale) {
      const figures = mode.value === "free" ? { texts: ["0°", "90°", "180°", "270°"], bold: false } : { texts: compass(), bold: true };
      drawFloor(floor.getContext("2d") as CanvasRenderingContext2D, camera, ink, shown, figures, [size.width, size.height]);
      stale = false;
    }
    const context = over.getContext("2d") as CanvasRenderingContext2D;
    const below = under.getContext("2d") as CanvasRenderingContext2D;
    for (const one of [context, below]) one.clearRect(0, 0, size.width, size.height);
    const scene: Pick<Scene, "camera" | "ink" | "floorRadius" | "rod"> = { camera, ink, floorRadius: shown, rod: now.mode === "free" && now.summary.tension[0] < 0 };
    below.globalAlpha = way ? way.seen : 1;
    if (averaging.value && !gripped.value) renderer.draw(remembered(onTheWay(averagedScene(scene, now, clock.time, below), way)));
    else {
      const state = gripped.value ? now.main.motion.state(0) : null;
      const seen = state ? held(now, state) : moving(now, beside.value, ink);
      const threads = seen.bobs.filter((one) => !one.ring).map((one) => one.at);
      const met = meetingNow(now);
      if (met !== null && !gripped.value) {
        drawBearing(below, camera, 0.8 * shown, now.hand.azimuth + now.settled.earth * clock.time, ink.color[EARTH.ink], EARTH.width, EARTH.dash);
        drawBearing(below, camera, 0.96 * shown, met, ink.color.exact, 1.8, []);
      }
      renderer.draw(remembered(onTheWay({ ...scene, strands: seen.strands, bobs: seen.bobs, threads }, way)));
      if (gripped.value) drawOver(context, camera, ink, now);
      else if (kiosk.value && mode.value === "free" && clock.time < ARROW_SHOWN && preset.value === null) drawArrow(context, ink);
    }
    placeHandles(box, now, way);
  };
  const stopFrames = onFrame(paint);
  const stopLaunches = effect(() => {
    void [launches.value, gripped.value, averaging.value, beside.value, core.value];
    redraw();
  });
  return () => {
    stopFrames();
    stopInk();
    stopLaunches();
    observer.disconnect();
    space.removeEventListener("webglcontextlost", onLost);
    space.removeEventListener("webglcontextrestored", onRestored);
    deep?.dispose();
  };
}

/** What is drawn while the bob is on its way to where this scene begins. */
function onTheWay(scene: Scene, way: Passed | null): Scene {
  const main = scene.bobs.find((one) => !one.ring);
  if (!way || !main) return scene;
  if (way.way < 1) {
    const at = way.at(main.at);
    return { ...scene, strands: way.past.strands, bobs: [...way.past.bobs, { ...main, at, alpha: 1 }], threads: [at] };
  }
  const strands = scene.strands.map((one) => ({ ...one, alpha: [way.seen * one.alpha[0], way.seen * one.alpha[1]] as const }));
  const bobs = scene.bobs.map((one) => (one === main ? one : { ...one, alpha: way.seen * one.alpha }));
  return { ...scene, strands, bobs };
}

/** px that a note at the lower edge of the stage takes; one above lies beside the support. */
function noted(box: HTMLElement, height: number): number {
  const note = box.parentElement?.querySelector<HTMLElement>(".stage-note");
  return note && note.offsetTop > height / 2 ? note.offsetHeight : 0;
}

/** East is at 0°, north at 90°; at the poles letters mean nothing. */
function compass(): string[] {
  const latitude = given.value.site?.latitude ?? 0;
  if (Math.abs(latitude) > 89.99 * DEGREE) return ["0°", "90°", "180°", "270°"];
  const [north = "N", east = "E", south = "S", west = "W"] = words.value.foucault.compass;
  return [east, north, west, south];
}

/** Dragging the empty stage turns the view; a double tap brings it back. The wheel scrolls the page. */
function Orbit() {
  const at = useRef<{ x: number; y: number } | null>(null);
  return (
    <div
      class="orbit"
      onPointerDown={(event) => {
        if (event.pointerType === "touch") return;
        at.current = { x: event.clientX, y: event.clientY };
        event.currentTarget.setPointerCapture(event.pointerId);
      }}
      onPointerMove={(event) => {
        if (!at.current || !event.buttons) return;
        turn((at.current.x - event.clientX) * 0.006, (event.clientY - at.current.y) * 0.004);
        at.current = { x: event.clientX, y: event.clientY };
        redraw();
      }}
      onPointerUp={() => (at.current = null)}
      onDblClick={() => {
        goHome(mode.value === "free" ? "free" : "foucault");
        redraw();
      }}
    />
  );
}
