import { expect, test } from "@playwright/test";
import config from "../playwright.config";
import { drawn, open } from "./page";

test.use({
  locale: "en-GB",
  contextOptions: { reducedMotion: "reduce" },
  viewport: { width: 1024, height: 768 },
  launchOptions: { ...config.use?.launchOptions, args: ["--no-sandbox", "--disable-gpu", "--disable-3d-apis"] },
});

test("without WebGL the page draws flat, and says so", async ({ page }) => {
  await open(page, "t=20");
  await expect(page.locator(".stage-foot")).toHaveText("Without WebGL the page draws flat.");
  expect(await drawn(page, "[data-layer=flat]")).toBeGreaterThan(800);
});
