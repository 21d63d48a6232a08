/** What moves by itself for who has nothing against it: the way to another example, and a kiosk that nobody touches. */

import { expect, test, type Page } from "@playwright/test";
import { between } from "../src/stage/travel";
import { time } from "./page";

test.use({ locale: "en-GB", contextOptions: { reducedMotion: "no-preference" }, viewport: { width: 760, height: 720 } });

async function bob(page: Page): Promise<readonly [number, number]> {
  const said = (await page.locator(".bob-handle").getAttribute("style")) ?? "";
  const [, x, y] = /translate\(([-\d.]+)px, ([-\d.]+)px\)/.exec(said) ?? [];
  return [Number(x), Number(y)];
}

/** Opens the page, whose time stands still from now on: each leap of it is one frame. */
async function openStill(page: Page, fragment: string): Promise<void> {
  await page.clock.install({ time: 0 });
  await page.goto(`./${fragment}`);
  await expect(page.locator("html")).toHaveAttribute("data-ready", "", { timeout: 25_000 });
  await page.clock.pauseAt(40_000);
}

const apart = (one: readonly [number, number], other: readonly [number, number]): number => Math.hypot(one[0] - other[0], one[1] - other[1]);

test("to another example the bob travels, rests where it begins, and goes", async ({ page }) => {
  await openStill(page, "");
  await page.clock.fastForward(20);
  await page.getByRole("button", { name: "Cone", exact: true }).click();
  await page.clock.fastForward(20);
  const way = [await bob(page)];
  for (let step = 0; step < 5; step++) {
    await page.clock.fastForward(155);
    way.push(await bob(page));
  }
  const end = way.at(-1)!;
  // It has come to its end after 600 ms, by steps of which none is the whole, and time has waited for it.
  expect(apart(way[4]!, end)).toBeLessThan(1);
  const steps = way.slice(1).map((one, index) => apart(one, way[index]!));
  const whole = steps.reduce((sum, one) => sum + one, 0);
  expect(whole).toBeGreaterThan(30);
  expect(Math.max(...steps)).toBeLessThan(0.6 * whole);
  expect(await time(page)).toBe(2);
  for (let frame = 0; frame < 4; frame++) await page.clock.fastForward(155);
  expect(await time(page)).toBeGreaterThan(2);
  expect(apart(await bob(page), end)).toBeGreaterThan(5);
});

test("a way on the sphere stays on it, and ends where it leads", () => {
  const [from, to] = [[0.6, 0, -0.8], [0, -0.28, 0.96]] as const;
  for (const share of [0, 0.2, 0.5, 1]) expect(Math.hypot(...between(from, to, share))).toBeCloseTo(1, 12);
  between(from, to, 1).forEach((one, index) => expect(one).toBeCloseTo(to[index]!, 12));
  expect(between(from, from, 0.7)).toEqual(from);
});

test("where nobody is, a pale hand pulls the bob, then shows the next example, and stops at a touch", async ({ page }) => {
  await openStill(page, "#kiosk=1");
  await page.clock.fastForward(6000);
  await expect(page.locator(".still .ring")).toBeVisible();
  await page.clock.fastForward(15_000);
  const hand = page.locator(".pale-hand");
  await expect(hand).toBeHidden();
  await page.clock.fastForward(20_000);
  await page.clock.fastForward(20);
  await expect(hand).toBeVisible();
  await page.clock.fastForward(2000);
  await expect(hand).toBeHidden();
  await expect(page.locator(".title")).toHaveText("The ellipse that turns");
  await page.clock.fastForward(18_000);
  await page.clock.fastForward(20_000);
  await page.clock.fastForward(20);
  await expect(hand).toBeVisible();
  await expect(page.locator(".title")).toHaveText("Small and patient");
  await page.mouse.click(300, 20);
  await page.clock.fastForward(20);
  await expect(hand).toBeHidden();
  await page.clock.fastForward(30_000);
  await expect(hand).toBeHidden();
  await expect(page.locator(".title")).toHaveText("Small and patient");
});
