import { readFileSync } from "node:fs";
import { expect, test, type Page } from "@playwright/test";
import { open } from "./page";

test.use({ locale: "en-GB", contextOptions: { reducedMotion: "reduce" }, viewport: { width: 1280, height: 800 }, permissions: ["clipboard-read", "clipboard-write"] });

async function saved(page: Page, item: string): Promise<{ name: string; content: Buffer }> {
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: item }).click()]);
  return { name: download.suggestedFilename(), content: readFileSync(await download.path()) };
}

test("the link brings back the same state, at the same moment", async ({ page }) => {
  await open(page, "preset=cone&t=14");
  await page.getByRole("button", { name: "Share" }).click();
  await page.getByRole("button", { name: "Copy link" }).click();
  await expect(page.getByRole("button", { name: "Copied" })).toBeVisible();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  expect(link).toContain("launch.kind=angles");
  await page.goto("about:blank");
  await page.goto(link);
  await expect(page.locator(".title")).toHaveText("In a circle");
  await expect(page.locator(".seek")).toHaveAttribute("aria-valuenow", "14");
});

test("job file, table and picture can be taken away", async ({ page }) => {
  await open(page);
  await page.getByRole("button", { name: "Share" }).click();
  const job = await saved(page, "Save job file");
  expect(job.name).toBe("kugelpendel-rosette.toml");
  expect(job.content.toString()).toContain('[launch]\nkind = "plane"\nx = "45 cm"');
  expect(job.content.toString()).toContain('duration = "40 s"');
  const table = await saved(page, "Numbers as CSV");
  const rows = table.content.toString().trim().split("\n");
  expect(rows[0]).toBe("time [s],x [m],y [m],z [m]");
  expect(rows).toHaveLength(2002);
  const [time, x, y, z] = (rows[1] ?? "").split(",").map(Number);
  expect([time, y]).toEqual([0, 0]);
  expect(x).toBeCloseTo(0.45, 14);
  expect(z).toBeCloseTo(Math.sqrt(1 - 0.45 ** 2), 12);
  const picture = await saved(page, "Picture with numbers");
  expect(picture.content.subarray(1, 4).toString()).toBe("PNG");
  expect(picture.content.readUInt32BE(16)).toBe(1600);
  expect(picture.content.length).toBeGreaterThan(40_000);
});

test("the averaged motion is saved as its ellipses", async ({ page }) => {
  await open(page, "preset=southpole");
  await page.getByRole("button", { name: "Share" }).click();
  const rows = (await saved(page, "Numbers as CSV")).content.toString().trim().split("\n");
  expect(rows[0]).toBe("time [s],a [m],b [m],azimuth [deg]");
  const [time = 0, a, , azimuth = 0] = (rows.at(-1) ?? "").split(",").map(Number);
  expect(time).toBe(86_400);
  expect(a).toBeCloseTo(1, 3);
  // The Earth turns by 360.99° in a day, and the plane in the south counter-clockwise.
  expect(azimuth).toBeCloseTo(360.99, 0);
});
