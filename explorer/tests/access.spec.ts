import { AxeBuilder } from "@axe-core/playwright";
import { expect, test, type Page } from "@playwright/test";
import { open } from "./page";

test.use({ locale: "de-DE", contextOptions: { reducedMotion: "reduce" }, viewport: { width: 1280, height: 800 } });

async function findings(page: Page): Promise<string[]> {
  // What passes is not listed, and, as the page has no frames, no second page is opened to gather them.
  const { violations } = await new AxeBuilder({ page }).options({ resultTypes: ["violations"] }).setLegacyMode().analyze();
  return violations.filter(({ impact }) => impact === "serious" || impact === "critical").map(({ id, nodes }) => `${id}: ${nodes.map((one) => one.target).join(" ")}`);
}

test("nobody is shut out: free, with a ruler and an explanation open", async ({ page }) => {
  await open(page);
  expect(await findings(page)).toEqual([]);
  await page.getByRole("button", { name: /^Länge/ }).click();
  await page.getByRole("button", { name: "4,95 °/s" }).click();
  expect(await findings(page)).toEqual([]);
});

test("nobody is shut out on the turning ground, in the dark, on a phone, in a kiosk", async ({ page }) => {
  await open(page, "preset=guelph");
  await page.getByRole("button", { name: /^Hell\/dunkel/ }).click();
  await page.getByRole("button", { name: /^Hell\/dunkel/ }).click();
  await expect(page.locator("html")).toHaveAttribute("data-theme", "dark");
  // Colours change softly.
  await page.waitForTimeout(300);
  expect(await findings(page)).toEqual([]);
  await page.setViewportSize({ width: 360, height: 640 });
  await page.getByRole("button", { name: "Mehr" }).click();
  expect(await findings(page)).toEqual([]);
  await page.goto("about:blank");
  await open(page, "kiosk=1&preset=pantheon");
  expect(await findings(page)).toEqual([]);
});

test("all can be reached by keys, and what moves is told in words on change", async ({ page }) => {
  await open(page);
  await expect(page.locator("[data-live]")).toContainText("Die Ellipse, die sich dreht. Zeit 6,0");
  const seen = new Set<string>();
  for (let index = 0; index < 70; index++) {
    await page.keyboard.press("Tab");
    seen.add(await page.evaluate(() => {
      const one = document.activeElement;
      return one?.getAttribute("aria-label") ?? one?.textContent ?? "";
    }));
  }
  for (const name of ["Pendel", "Foucault", "Herleitung", "Teilen", "Kugel", "Schritt", "Rosette", "Guelph"]) expect([...seen]).toContain(name);
});
