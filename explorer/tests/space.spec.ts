import { expect, test } from "@playwright/test";
import config from "../playwright.config";
import { drawn, open } from "./page";

// WebGL by software, so that it is there on a machine without a graphics processor.
test.use({
  locale: "en-GB",
  contextOptions: { reducedMotion: "reduce" },
  viewport: { width: 760, height: 560 },
  launchOptions: { ...config.use?.launchOptions, args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"] },
});

test("the pendulum is drawn in space; a lost context is drawn flat until it is back", async ({ page }) => {
  const slow = { timeout: 20_000 };
  const errors = await open(page);
  await expect(page.locator("[data-graphics=space]")).toBeVisible();
  await expect.poll(() => drawn(page, "[data-layer=space]"), slow).toBeGreaterThan(100);
  await page.locator("[data-layer=space]").evaluate((canvas) => {
    const extension = (canvas as HTMLCanvasElement).getContext("webgl2")?.getExtension("WEBGL_lose_context");
    extension?.loseContext();
    (window as unknown as { restore: () => void }).restore = () => extension?.restoreContext();
  });
  await expect(page.locator(".stage-foot")).toContainText("The graphics processor has dropped out.");
  await expect.poll(() => drawn(page, "[data-layer=flat]"), slow).toBeGreaterThan(100);
  await page.evaluate(() => (window as unknown as { restore: () => void }).restore());
  await expect(page.locator("[data-graphics=space]")).toBeVisible(slow);
  await expect.poll(() => drawn(page, "[data-layer=space]"), slow).toBeGreaterThan(100);
  expect(errors.filter((text) => !text.includes("Context Lost"))).toEqual([]);
});
