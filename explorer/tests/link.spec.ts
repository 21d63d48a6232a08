/** Links and job files: what is understood, what is void, and that nothing of a link is more than a number or a known word. */
import { expect, test } from "@playwright/test";
import { readLink, readQuantity, writeJobFile, writeLink, writeQuantity, type Link } from "../src/job";

const PANTHEON =
  "pendulum.length=67&launch.kind=ellipse&launch.a=3&launch.b=0&site.latitude=0.85&drag.half_life=14400&output.duration=86400";

test("a link is read by the keys of job files", () => {
  const { given, duration, view, garbled } = readLink(`#${PANTHEON}&lang=de&kiosk=1&t=12.5&beside=cubic,linear&rod=1`);
  expect(garbled).toBe(false);
  expect(given).toEqual({
    pendulum: { length: 67 },
    launch: { kind: "ellipse", a: 3, b: 0 },
    site: { latitude: 0.85 },
    drag: { half_life: 14400 },
  });
  expect(duration).toBe(86400);
  expect(view).toEqual({ lang: "de", kiosk: true, t: 12.5, beside: ["cubic", "linear"], rod: true });
});

test("an empty link says nothing, and is not garbled", () => {
  expect(readLink("")).toEqual({ given: null, duration: null, view: {}, garbled: false });
  expect(readLink("#lang=en")).toEqual({ given: null, duration: null, view: { lang: "en" }, garbled: false });
});

test("quantities may have units", () => {
  const { given } = readLink("pendulum.length=67+m&launch.kind=at_rest&launch.theta=30%20deg");
  expect(given).toEqual({ pendulum: { length: 67 }, launch: { kind: "at_rest", theta: 30 * (Math.PI / 180) } });
});

const VOID = [
  "garbage",
  "=",
  "&&",
  "pendulum.length=67", // no launch
  "launch.kind=ellipse&launch.a=1&launch.b=0", // no pendulum
  PANTHEON.replace("=67", "=long"),
  PANTHEON.replace("=67", "=1e999"),
  PANTHEON.replace("=67", "=NaN"),
  PANTHEON.replace("=67", "=0x10"),
  PANTHEON.replace("=67", "=67 s"),
  PANTHEON.replace("=67", "=%E0%A4%A"),
  PANTHEON.replace("ellipse", "__proto__"),
  PANTHEON.replace("ellipse", "constructor"),
  PANTHEON.replace("pendulum.length", "__proto__.length"),
  PANTHEON.replace("pendulum.length", "pendulum.__proto__"),
  PANTHEON.replace("launch.b=0", "launch.c=0"),
  PANTHEON.replace("&launch.b=0", ""),
  PANTHEON.replace("output.duration=86400", "output.duration=-1"),
  PANTHEON.replace("output.duration", "output.format"),
  `${PANTHEON}&pendulum.length=67`, // twice
  `${PANTHEON}&drag.quality=800`, // two ways to say it
  `${PANTHEON}&drag.thread_diameter=1`,
  `${PANTHEON}&suspension.period_along=8`, // half a way
  `${PANTHEON}&bob.density=8000`, // no size
  `${PANTHEON}&drive.push=1e-3`, // no moment
  `${PANTHEON}&lang=fr`,
  `${PANTHEON}&preset=<img src=x>`,
  `${PANTHEON}&preset=..%2F..%2Fetc`,
  `${PANTHEON}&beside=exact`,
  `${PANTHEON}&kiosk=true`,
  `${PANTHEON}&url=https://example.org`,
  `${PANTHEON}&a.b.c=1`,
  "x".repeat(5000),
];

test("anything that is not expected makes a link void as a whole", () => {
  for (const link of VOID) {
    expect(readLink(link), link).toEqual({ given: null, duration: null, view: {}, garbled: true });
  }
});

const LINKS: Link[] = [
  { given: null, duration: null, view: { kiosk: true, preset: "rosette" } },
  {
    given: {
      pendulum: { length: 0.83, mass: 4.5 },
      launch: { kind: "state", position: [0.1, -0.2, 0.7], velocity: [1e-9, 0, 0.30000000000000004] },
      site: { latitude: -1.5, height: 2835 },
      drag: { from_bob: true, thread_diameter: 0.001 },
      suspension: { period_along: 8.97, period_across: 8.98, axis: 0.3 },
      bob: { diameter: 0.2, density: 8500 },
      drive: { push: 1.0395e-4, phase: 0.4 },
    },
    duration: 129600,
    view: { beside: [], t: 1 / 3, lang: "en" },
  },
  { given: { pendulum: { length: 1 }, launch: { kind: "plane", x: 0.45, y: 0, vx: 0, vy: 0.5 } }, duration: 60, view: {} },
];

test("what is written is read again", () => {
  for (const link of LINKS) expect(readLink(writeLink(link))).toEqual({ ...link, garbled: false });
});

test("texts read as the number that they were made of", () => {
  for (const [value, text] of [[0.45, "45 cm"], [67, "67 m"], [0.001, "1 mm"], [1 / 3, "0.3333333333333333 m"], [0, "0 m"]] as const) {
    expect(writeQuantity(value, "length")).toBe(text);
    expect(readQuantity(text, "length")).toBe(value);
  }
  expect(writeQuantity(30 * (Math.PI / 180), "angle")).toBe("30 deg");
  expect(writeQuantity(86400, "time")).toBe("1 d");
  expect(readQuantity("1.2.3 m", "length")).toBeNull();
  expect(readQuantity("3 parsec", "length")).toBeNull();
});

test("a job file has the tables and keys of the job", () => {
  const [, , link] = LINKS;
  if (!link?.given) throw new Error("the last link has a launch");
  expect(writeJobFile(link.given, 60)).toBe(
    [
      "[pendulum]", 'length = "1 m"', "",
      "[launch]", 'kind = "plane"', 'x = "45 cm"', 'y = "0 m"', 'vx = "0 m/s"', 'vy = "0.5 m/s"', "",
      "[output]", 'duration = "60 s"', "samples = 1001", "",
    ].join("\n"),
  );
});
