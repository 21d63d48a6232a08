import { expect, test } from "@playwright/test";
import { de } from "../src/words/de";
import { en } from "../src/words/en";
import { PRESET_KEYS, presetsDe, presetsEn } from "../src/words/presets";
import { open } from "./page";

test.use({ locale: "en-GB", contextOptions: { reducedMotion: "reduce" }, viewport: { width: 1280, height: 800 } });

/** What each example says of its motion, as the core computes it and as Python does (examples/, design of the page). */
const SAID: Readonly<Record<(typeof PRESET_KEYS)[number], readonly string[]>> = {
  rosette: ["2.037 s", "4.95 °/s", "1 min 13 s"],
  small: ["2.008 s", "0.202 °/s", "29 min 42 s"],
  straight: ["16.423 s", "0.198 °/h", "75.8 d"],
  cone: ["1.059 s", "218.3°"],
  over: ["1.188 s", "9.9°", "back"],
  separatrix: ["3.466 s", "194.6°"],
  pantheon: ["clockwise at 11.33 °/h"],
  southpole: ["counter-clockwise at 15.04 °/h"],
  equator: ["does not turn the plane here", "it stands"],
  short: ["clockwise at 11.18 °/h"],
  bravais: ["6.34024 s", "6.33954 s"],
  guelph: ["clockwise at 10.36 °/h"],
};

test("each example shows its motion, says its numbers, and stands in the address", async ({ page }) => {
  const errors = await open(page);
  for (const key of PRESET_KEYS) {
    await page.getByRole("navigation").getByRole("button", { name: presetsEn[key].name, exact: true }).click();
    await expect(page.locator(".title")).toHaveText(presetsEn[key].title);
    const said = (await page.locator(".follows").textContent())?.replaceAll("\u00a0", " ");
    for (const text of SAID[key]) expect(said).toContain(text);
    expect(new URL(page.url()).hash).toContain(`preset=${key}`);
  }
  expect(errors).toEqual([]);
});

test("the plane that stalls is said to, and Guelph's drive to keep it going", async ({ page }) => {
  await open(page, "preset=short&t=7920");
  await expect(page.locator(".follows")).toContainText("the other way");
  await expect(page.locator(".portrait")).toContainText("Yes: the line ends in a point.", { timeout: 15_000 });
  await page.getByRole("button", { name: "Guelph" }).click();
  await expect(page.locator(".portrait")).toContainText("No: the drive keeps it going.", { timeout: 15_000 });
  await expect(page.getByRole("button", { name: "Deviation" })).toHaveAttribute("aria-pressed", "true");
});

test("the shares add up to what is said to turn the plane", async ({ page }) => {
  await open(page, "preset=pantheon&t=15420");
  const numbers = (await page.locator(".shares .number").allTextContents()).map((text) => Number(text.replace("−", "-").replace("+", "")));
  const total = numbers.pop()!;
  expect(total).toBeCloseTo(numbers.reduce((sum, one) => sum + one, 0), 1);
  expect(total).toBeCloseTo(-11.67, 1);
});

test("the latitude is picked on the globe, by keys and by its places", async ({ page }) => {
  await open(page, "preset=southpole");
  const globe = page.getByRole("slider", { name: "Latitude" });
  await expect(globe).toHaveAttribute("aria-valuetext", "90° S");
  await globe.focus();
  await page.keyboard.press("ArrowUp");
  await expect(page.locator(".latitude")).toHaveText("89° S");
  await page.getByRole("button", { name: "Equator" }).first().click();
  await expect(page.locator(".follows")).toContainText("does not turn the plane here");
  const box = (await globe.boundingBox())!;
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2 - 40, { steps: 4 });
  await page.mouse.up();
  await expect(page.locator(".latitude")).toContainText("N");
});

test("drag, clamp and drive are set in the sentence", async ({ page }) => {
  await open(page, "preset=guelph");
  await page.getByRole("button", { name: "with drive" }).click();
  await expect(page.locator(".given")).toContainText("no drive");
  // A swing that the air brakes less is pumped by the drive as it is: the core says so, and what would keep it.
  await page.getByRole("button", { name: "no drive" }).click();
  await page.getByRole("button", { name: /^Time in which the swing halves/ }).click();
  await page.getByRole("textbox").fill("1e5 s");
  await page.keyboard.press("Enter");
  await expect(page.locator(".refusal")).toHaveText(/^The drive's push of 0\.00010395 m\/s pumps without end: .*; push = 7\.205e-07 keeps an amplitude of 0\.03 m\.$/);
  await page.getByRole("button", { name: "weaker drive" }).click();
  await expect(page.locator(".given")).toContainText("halves that in 27.8 h");
  await expect(page.locator(".given")).toContainText("with drive");
  await page.getByRole("button", { name: "with drive" }).click();
  await page.getByRole("button", { name: /^How uneven the clamp is/ }).click();
  await page.locator(".ruler").getByRole("button", { name: "even" }).click();
  await expect(page.locator(".portrait")).toContainText("No: the clamp is even.", { timeout: 15_000 });
  await page.getByRole("button", { name: /^Time in which the swing halves/ }).click();
  await page.getByRole("button", { name: "nothing brakes it" }).click();
  await expect(page.locator(".given")).toContainText("Nothing brakes it");
});

test("where time runs fast the ellipse is drawn, and said to be; at a slow speed the bob is back", async ({ page }) => {
  await open(page, "preset=pantheon");
  await expect(page.locator(".stage-note")).toContainText("1 s here is 1 h there. The bob would be a blur.");
  for (let index = 0; index < 4; index++) await page.getByRole("button", { name: "slower" }).click();
  await expect(page.locator(".stage-note")).toContainText("times as wide as it swings");
});

test("the German sentences have the same holes as the English ones", () => {
  const holes = (text: string): string => [...text.matchAll(/\{\w+\}/g)].map(String).sort().join();
  const compare = (one: unknown, other: unknown, path: string): void => {
    if (typeof one === "string") expect(holes(other as string), path).toBe(holes(one));
    else for (const [key, value] of Object.entries(one as object)) compare(value, (other as Record<string, unknown>)[key], `${path}.${key}`);
  };
  compare(en, de, "words");
  compare(presetsEn, presetsDe, "presets");
});
