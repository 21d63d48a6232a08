/** The latitude, picked from a small globe: up and down is the latitude, arrows go by a degree. */

import { geoGraticule, geoOrthographic, geoPath } from "d3-geo";
import { useRef } from "preact/hooks";
import { feature } from "topojson-client";
import type { GeometryCollection, Topology } from "topojson-specification";
import landTopology from "world-atlas/land-110m.json";
import { useDrawing } from "../instruments/canvas";
import { DEGREE } from "../numbers/ladders";
import { decimals } from "../numbers/spell";
import { faded } from "../drawing/ink";
import { given, launches, relaunch } from "../state/page";
import { redraw } from "../state/loop";
import { fill, language, words } from "../words/language";

const topology = landTopology as unknown as Topology<{ land: GeometryCollection }>;
const land = feature(topology, topology.objects.land);

/** From where the globe is seen, degrees. */
const LONGITUDE = 12;
const TILT = 18;

/** A pull that comes so close to a place of note stays there, degrees. */
const SNAP = 1.5;

export function Globe() {
  const canvas = useRef<HTMLCanvasElement>(null);
  const held = useRef<{ y: number; from: number } | null>(null);
  useDrawing(canvas, (context, ink, width) => drawGlobe(context, ink.color, width));
  void launches.value;
  const say = words.value.foucault;
  const latitude = (given.value.site?.latitude ?? 0) / DEGREE;
  const shown = spelled(latitude);
  const set = (value: number): void => {
    const next = Math.min(90, Math.max(-90, value));
    relaunch({ ...given.value, site: { ...given.value.site, latitude: next * DEGREE } });
    redraw();
  };
  const places = [
    { name: say.north, value: 90 },
    { name: say.paris, value: 48.846 },
    { name: say.equator, value: 0 },
    { name: say.south, value: -90 },
  ];
  return (
    <section class="globe" aria-label={say.globe}>
      <canvas
        ref={canvas}
        role="slider"
        tabIndex={0}
        aria-label={say.globe}
        aria-valuemin={-90}
        aria-valuemax={90}
        aria-valuenow={Number(latitude.toFixed(3))}
        aria-valuetext={shown}
        onKeyDown={(event) => {
          const ways: Readonly<Record<string, number>> = { ArrowUp: latitude + 1, ArrowRight: latitude + 1, ArrowDown: latitude - 1, ArrowLeft: latitude - 1, PageUp: latitude + 10, PageDown: latitude - 10, Home: -90, End: 90 };
          const next = ways[event.key];
          if (next === undefined) return;
          event.preventDefault();
          set(Number(next.toPrecision(8)));
        }}
        onPointerDown={(event) => {
          event.currentTarget.setPointerCapture(event.pointerId);
          held.current = { y: event.clientY, from: latitude };
        }}
        onPointerMove={(event) => {
          if (!held.current || !event.buttons) return;
          const radius = event.currentTarget.clientHeight / 2;
          const wanted = held.current.from + ((held.current.y - event.clientY) / radius) * 70;
          const near = places.find(({ value }) => Math.abs(value - wanted) < SNAP);
          set(near ? near.value : Math.round(wanted * 10) / 10);
        }}
        onPointerUp={() => (held.current = null)}
      />
      <div>
        <p class="latitude">{shown}</p>
        <div class="chips">
          {places.map(({ name, value }) => (
            <button key={name} type="button" class="chip" aria-pressed={Math.abs(value - latitude) < 1e-6} onClick={() => set(value)}>
              {name}
            </button>
          ))}
        </div>
      </div>
    </section>
  );
}

function spelled(latitude: number): string {
  const say = words.value.foucault;
  const rounded = Math.abs(Number(latitude.toFixed(2)));
  const value = `${decimals(rounded, Number.isInteger(rounded) ? 0 : 2, language.value)}°`;
  if (rounded === 0) return value;
  return fill(latitude > 0 ? say.latitudeNorth : say.latitudeSouth, { value });
}

function drawGlobe(context: CanvasRenderingContext2D, color: Readonly<Record<string, string>>, size: number): void {
  const middle = size / 2;
  const radius = middle - 7;
  const projection = geoOrthographic().rotate([-LONGITUDE, -TILT]).translate([middle, middle]).scale(radius).clipAngle(90);
  const path = geoPath(projection, context);
  context.clearRect(0, 0, size, size);
  const fillPath = (style: string): void => {
    context.fillStyle = style;
    context.fill();
  };
  context.beginPath();
  path({ type: "Sphere" });
  fillPath(color["sea"] ?? "");
  context.beginPath();
  path(land);
  fillPath(color["land"] ?? "");
  context.beginPath();
  path(geoGraticule().step([30, 30])());
  context.strokeStyle = faded(color["ink"] ?? "", 0.12);
  context.lineWidth = 1;
  context.stroke();
  const shade = context.createRadialGradient(0.75 * middle, 0.65 * middle, 0.2 * radius, middle, middle, radius);
  shade.addColorStop(0, "rgb(255 255 255 / 0.12)");
  shade.addColorStop(1, "rgb(0 0 0 / 0.28)");
  context.beginPath();
  path({ type: "Sphere" });
  fillPath(shade as unknown as string);
  context.strokeStyle = color["edge"] ?? "";
  context.stroke();
  const latitude = (given.value.site?.latitude ?? 0) / DEGREE;
  const ring = Array.from({ length: 121 }, (_, index) => [LONGITUDE - 180 + 3 * index, latitude]);
  context.beginPath();
  path({ type: "LineString", coordinates: ring });
  context.strokeStyle = color["accent"] ?? "";
  context.lineWidth = 3;
  context.stroke();
  // The handle sits on the meridian in front, or on the rim where that is behind.
  const [x, y] = projection([LONGITUDE - 6, latitude]) ?? [middle, latitude < 0 ? middle + radius : middle - radius];
  const seen = latitude > TILT - 90;
  context.beginPath();
  context.arc(seen ? x : middle, seen ? y : middle + radius, 7, 0, 2 * Math.PI);
  fillPath(color["paper"] ?? "");
  context.stroke();
}
