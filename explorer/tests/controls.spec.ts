import { expect, test } from "@playwright/test";
import { ends, glide } from "../src/sentence/scale";
import { drawn, open, time } from "./page";

test.use({ locale: "de-DE", contextOptions: { reducedMotion: "reduce" }, viewport: { width: 1280, height: 800 } });

test("the default says its numbers and draws its rosette, paused for who wants less motion", async ({ page }) => {
  const errors = await open(page);
  await expect(page.locator(".follows")).toHaveText("Hin und zurück in 2,037 s. Die Ellipse dreht sich mit 4,95 °/s, in 1 min 13 s einmal herum.");
  await expect(page.locator(".formula-note")).toContainText("Die Formel (25) sagt 4,69 °/s, das sind 5,2 % zu wenig.");
  await expect(page.getByRole("button", { name: "Weiter" })).toBeVisible();
  expect(await time(page)).toBe(6);
  expect(await drawn(page, ".plan canvas")).toBeGreaterThan(500);
  expect(errors).toEqual([]);
});

test("play goes on, pause stops, and a step is a forty-eighth of a swing", async ({ page }) => {
  await open(page);
  await page.getByRole("button", { name: "Weiter" }).click();
  await expect.poll(() => time(page)).toBeGreaterThan(6);
  await page.getByRole("button", { name: "Pause" }).click();
  const stopped = await time(page);
  await page.getByRole("button", { name: "Schritt" }).click();
  await page.getByRole("button", { name: "Schritt" }).click();
  await page.getByRole("button", { name: "Schritt" }).click();
  await expect.poll(() => time(page)).toBeCloseTo(stopped + 3 * (2.0368 / 48), 0);
  // Space plays where nothing has the focus.
  await page.locator(".title").click();
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  await page.keyboard.press("Space");
  await expect(page.getByRole("button", { name: "Pause" })).toBeVisible();
});

test("the speeds have a ladder with two ends", async ({ page }) => {
  await open(page);
  const shown = page.locator(".speed output");
  for (const text of ["2×", "5×", "20×"]) {
    await page.getByRole("button", { name: "schneller" }).click();
    await expect(shown).toHaveText(text);
  }
  await expect(page.getByRole("button", { name: "schneller" })).toBeDisabled();
  for (const text of ["5×", "2×", "1×", "½×", "¼×", "⅛×"]) {
    await page.getByRole("button", { name: "langsamer" }).click();
    await expect(shown).toHaveText(text);
  }
  await expect(page.locator(".speed")).toContainText("Zeitlupe");
  await expect(page.getByRole("button", { name: "langsamer" })).toBeDisabled();
});

test("time is sought on the curve, by pointer and by keys", async ({ page }) => {
  await open(page);
  const bar = page.getByRole("slider", { name: /^Zeit/ });
  await bar.focus();
  await page.keyboard.press("Home");
  expect(await time(page)).toBe(0);
  await page.keyboard.press("ArrowRight");
  expect(await time(page)).toBeCloseTo(2.0368, 1);
  await page.keyboard.press("End");
  expect(await time(page)).toBe(40);
  const box = (await bar.boundingBox())!;
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  expect(await time(page)).toBeGreaterThan(10);
  expect(await time(page)).toBeLessThan(35);
});

test("each quantity opens its ruler, obeys keys, chips and typing, and says what cannot be", async ({ page }) => {
  await open(page);
  await page.getByRole("button", { name: "Länge: 1,00 m" }).click();
  const ruler = page.getByRole("slider", { name: "Länge" });
  await expect(ruler).toBeFocused();
  await page.keyboard.press("ArrowRight");
  await expect(page.getByRole("button", { name: "Länge: 1,10 m" })).toBeVisible();
  await page.keyboard.press("Shift+ArrowRight");
  await expect(page.getByRole("button", { name: "Länge: 1,11 m" })).toBeVisible();
  await page.getByRole("button", { name: "Foucault 67 m" }).click();
  await expect(page.locator(".given")).toContainText("67,0 m");
  const field = page.getByRole("textbox");
  await field.fill("1,5 m");
  await page.keyboard.press("Enter");
  await expect(page.locator(".given")).toContainText("1,50 m");
  await field.fill("drei Ellen");
  await page.keyboard.press("Enter");
  await expect(page.locator(".refusal")).toHaveText("Eine Länge wie 1,5 m oder 30 cm.");
  await field.fill("10 cm");
  await page.keyboard.press("Enter");
  await expect(page.locator(".refusal")).toContainText("Weniger als 45,9 cm geht hier nicht.");
  await page.getByRole("button", { name: "English" }).click();
  await expect(page.locator(".refusal")).toHaveText("It cannot be less here than 45.9 cm.");
  await page.getByRole("button", { name: "Deutsch" }).click();

  await page.getByRole("button", { name: /^Fallbeschleunigung/ }).click();
  await page.getByRole("button", { name: "Mond", exact: true }).click();
  await expect(page.locator(".given")).toContainText("auf dem Mond");
  await page.getByRole("textbox").fill("5 m/s²");
  await page.keyboard.press("Enter");
  await expect(page.locator(".given")).toContainText("bei 5,00 m/s²");

  await page.getByRole("button", { name: /^Quer dazu gestoßen/ }).click();
  await page.getByRole("button", { name: "kein Stoß" }).click();
  await expect(page.locator(".follows")).toContainText("Die Schwingung bleibt in ihrer Ebene.");

  await page.getByRole("button", { name: /^Zur Seite gezogen/ }).click();
  await page.getByRole("button", { name: "178° an einer Stange" }).click();
  await expect(page.locator(".given")).toContainText("Stange");
  await expect(page.locator(".title")).toHaveText("Eigener Wurf");
});

test("a ruler is dragged under its pointer, and so is the number itself", async ({ page }) => {
  await open(page);
  await page.getByRole("button", { name: "Länge: 1,00 m" }).click();
  const box = (await page.getByRole("slider", { name: "Länge" }).boundingBox())!;
  await page.mouse.move(box.x + 200, box.y + 30);
  await page.mouse.down();
  await page.mouse.move(box.x + 100, box.y + 30, { steps: 4 });
  await page.mouse.up();
  await expect(page.getByRole("button", { name: "Länge: 2,01 m" })).toBeVisible();
  // Drawn to its least value, its end is hatched from edge to middle.
  const before = await drawn(page, ".ruler canvas");
  await page.keyboard.press("Home");
  await expect(page.getByRole("button", { name: "Länge: 45,9 cm" })).toBeVisible();
  expect(await drawn(page, ".ruler canvas")).toBeGreaterThan(before);
  await page.getByRole("textbox").fill("2,01 m");
  await page.keyboard.press("Enter");
  const number = (await page.locator("#quantity-length").boundingBox())!;
  await page.mouse.move(number.x + 20, number.y + 10);
  await page.mouse.down();
  await page.mouse.move(number.x + 120, number.y + 10, { steps: 4 });
  await page.mouse.up();
  await expect(page.getByRole("button", { name: "Länge: 4,04 m" })).toBeVisible();
});

test("a number explains itself, Escape closes, and the focus goes back", async ({ page }) => {
  await open(page);
  const number = page.getByRole("button", { name: "4,95 °/s" });
  await number.click();
  const dialog = page.getByRole("dialog", { name: "Drehung der Ellipse" });
  await expect(dialog).toContainText("4,946400 °/s");
  await expect(dialog.getByRole("link")).toHaveAttribute("href", "derivation.de.html#eq-25");
  await page.keyboard.press("Escape");
  await expect(dialog).toBeHidden();
  await expect(number).toBeFocused();
});

test("a formula is switched off and on, and says its distance and its errors", async ({ page }) => {
  await open(page, "t=32.4");
  await expect(page.locator(".formulas")).toContainText("60,4 cm");
  await page.getByRole("button", { name: "Linear", exact: true }).click();
  await expect(page.locator(".formulas")).toContainText("aus");
  await expect.poll(() => page.url()).toContain("beside=cubic,ellipse");
  await page.getByRole("button", { name: "Linear", exact: true }).click();
  await page.locator(".formulas").getByRole("button", { name: "2,4 cm" }).click();
  await expect(page.getByRole("dialog", { name: "Kubisch" })).toContainText("2,1 % zu langsam");
});

test("languages, themes and modes are switched", async ({ page }) => {
  await open(page);
  await page.getByRole("button", { name: "English" }).click();
  await expect(page.locator(".title")).toHaveText("The ellipse that turns");
  await expect(page.locator(".follows")).toContainText("There and back in 2.037 s.");
  await expect(page.locator("html")).toHaveAttribute("lang", "en");
  await page.getByRole("button", { name: /^Light\/dark/ }).click();
  await page.getByRole("button", { name: /^Light\/dark/ }).click();
  await expect(page.locator("html")).toHaveAttribute("data-theme", "dark");
  await page.getByRole("button", { name: "Foucault", exact: true }).click();
  await expect(page.locator(".title")).toHaveText("The floor is turning");
  await page.getByRole("button", { name: "Pendulum", exact: true }).click();
  await expect(page.locator(".title")).toHaveText("The ellipse that turns");
});

test("a scale that is let go in motion glides on and comes to rest", () => {
  const way = Array.from({ length: 11 }, (_, step) => ({ x: 6 * step, time: 10 * step }));
  const thrown = glide(way, 100);
  // 0.6 px/ms, lost evenly within 200 ms.
  expect(thrown.whole).toBeCloseTo(60, 12);
  expect(thrown.at(0)).toEqual({ px: 0, done: false });
  expect(thrown.at(100).px).toBeCloseTo(45, 12);
  expect(thrown.at(250)).toEqual({ px: thrown.whole, done: true });
  // Held still before it is let go, or let go slowly, it stays.
  expect(glide(way, 400).whole).toBe(0);
  expect(glide([{ x: 0, time: 0 }, { x: 2, time: 50 }], 50).whole).toBe(0);
});

test("a ruler says where it ends", () => {
  const length = { si: "m", least: 0.1, most: 1000, value: 1 } as const;
  expect(ends(length, 1, 200)).toEqual([]);
  expect(ends(length, 0.1, 200)).toEqual([[-200, 0]]);
  expect(ends({ ...length, most: 10 }, 1, 400)).toEqual([[-400, -330], [330, 400]]);
});
