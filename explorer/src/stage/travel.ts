/**
 * The way to another example: what was drawn fades, the bob travels on the sphere to where it begins, rests there, and goes.
 * Who wants less motion sees a cut.
 */

import { batch, signal } from "@preact/signals";
import type { Camera, Point, Pose } from "../drawing/camera";
import type { Scene } from "../drawing/scene";
import { redraw } from "../state/loop";
import { clock, given, gripped, launch, launches, live, reducedMotion, show, waiting } from "../state/page";
import type { PresetKey } from "../words/presets";

/** How long each part takes, ms: what was drawn fades, the camera flies, the bob is on its way, and rests at its end. */
const FADE = 200;
const FLIGHT = 320;
const WAY = 600;
const REST = 300;

/** A hand takes its time. */
const BY_HAND = 1600;

interface Travel {
  /** What was drawn before, with points of its own. */
  readonly past: Scene;
  readonly from: Point;
  readonly pose: Pose;
  /** Of the motion to which it leads; another one ends it, and so does another time. */
  readonly launch: number;
  readonly time: number;
  readonly way: number;
  /** ms; the first frame says it */
  began: number | null;
}

let travel: Travel | null = null;
let drawn: Scene | null = null;

/** Whether a pale hand leads the bob. */
export const led = signal(false);

/** Remembers what is drawn, from which a travel sets out. */
export function remembered(scene: Scene): Scene {
  drawn = scene;
  return scene;
}

/** Shows an example, to which the bob travels. */
export function travelTo(key: PresetKey, byHand = false): void {
  set(() => show(key), byHand);
}

/** A pale hand takes the bob and lets it go where its motion began. */
export function leadBack(): void {
  set(() => launch(given.value), true);
}

function set(put: () => void, byHand: boolean): void {
  const scene = drawn;
  const bob = scene?.bobs.find((one) => !one.ring);
  if (!scene || !bob || reducedMotion.value || gripped.value) return put();
  // The core gives memory back with the motion that lay in it.
  const past = { ...scene, strands: scene.strands.map((one) => ({ ...one, name: `past ${one.name}`, points: one.points.slice() })) };
  const { pose } = scene.camera;
  const before = launches.value;
  batch(() => {
    put();
    if (launches.value === before) return;
    travel = { past, from: bob.at, pose, launch: launches.value, time: clock.time, way: byHand ? BY_HAND : WAY, began: null };
    waiting.value = true;
    led.value = byHand;
  });
  redraw();
}

export function endTravel(): void {
  travel = null;
  batch(() => {
    waiting.value = false;
    led.value = false;
  });
}

/** How far a travel is. */
export interface Passed {
  /** From 0 to 1 each: of the flight of the camera, of the way of the bob, and of how far the new motion is seen. */
  readonly flight: number;
  readonly way: number;
  readonly seen: number;
  readonly pose: Pose;
  readonly floor: number;
  /** What is left of what was drawn before. */
  readonly past: Pick<Scene, "strands" | "bobs">;
  /** Where the bob is on its way to a place. */
  at(to: Point): Point;
}

/** How far it is at this moment; null where nothing is on its way any more. */
export function passed(now: number): Passed | null {
  if (!travel) return null;
  const { past, from, pose, way } = travel;
  if (travel.launch !== launches.value || travel.time !== clock.time || gripped.value || !live.value) {
    endTravel();
    return null;
  }
  travel.began ??= now;
  const time = now - travel.began;
  if (time >= way + REST) {
    endTravel();
    return null;
  }
  const left = Math.max(0, 1 - time / FADE);
  const share = eased(Math.min(1, time / way));
  return {
    flight: eased(Math.min(1, time / FLIGHT)),
    way: share,
    seen: Math.min(1, Math.max(0, (time - way) / REST)),
    pose,
    floor: past.floorRadius,
    past: {
      strands: left > 0 ? past.strands.map((one) => ({ ...one, alpha: [left * one.alpha[0], left * one.alpha[1]] as const })) : [],
      bobs: left > 0 ? past.bobs.filter((one) => one.at !== from).map((one) => ({ ...one, alpha: left * one.alpha })) : [],
    },
    at: (to) => between(from, to, share),
  };
}

/** Whether the bob has come to where its motion begins. */
export function arrived(): boolean {
  return (passed(performance.now())?.way ?? 1) === 1;
}

/** Slow, fast, slow. */
function eased(share: number): number {
  return share * share * (3 - 2 * share);
}

/** On the great circle from one place of the unit sphere to another. */
export function between(from: Point, to: Point, share: number): Point {
  const cosine = Math.min(1, Math.max(-1, from[0] * to[0] + from[1] * to[1] + from[2] * to[2]));
  const angle = Math.acos(cosine);
  const sine = Math.sin(angle);
  // From one place to itself there is no way, and to the place opposite every way is as good.
  if (sine < 1e-6) return share < 0.5 ? from : to;
  const [one, other] = [Math.sin((1 - share) * angle) / sine, Math.sin(share * angle) / sine];
  return [one * from[0] + other * to[0], one * from[1] + other * to[1], one * from[2] + other * to[2]];
}

/** Turns the camera, which looks from its new place, so far back to where it came from. */
export function flown(camera: Camera, { pose, flight }: Passed): void {
  const aim = camera.pose;
  const mixed = (one: number, other: number): number => one + flight * (other - one);
  camera.pose = {
    azimuth: mixed(pose.azimuth, aim.azimuth),
    elevation: mixed(pose.elevation, aim.elevation),
    target: mixed(pose.target, aim.target),
    focal: mixed(pose.focal, aim.focal),
    centre: [mixed(pose.centre[0], aim.centre[0]), mixed(pose.centre[1], aim.centre[1])],
  };
}
