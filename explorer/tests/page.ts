/** How the tests open the page: standing still, as for somebody who wants less motion. */

import { expect, type Page } from "@playwright/test";

/** Opens the page with a fragment and waits until the core has moved the bob. */
export async function open(page: Page, fragment = "", errors: string[] = []): Promise<string[]> {
  page.on("pageerror", (error) => errors.push(error.message));
  page.on("console", (message) => {
    if (message.type() === "error") errors.push(message.text());
  });
  await page.goto(fragment ? `./#${fragment}` : "./");
  await expect(page.locator("html")).toHaveAttribute("data-ready", "", { timeout: 25_000 });
  return errors;
}

/** The time of the page, s. */
export async function time(page: Page): Promise<number> {
  return Number(await page.locator(".seek").getAttribute("aria-valuenow"));
}

/** How many pixels of a layer of the stage are not clear, in a stride of four. */
export async function drawn(page: Page, selector: string): Promise<number> {
  return page.locator(selector).evaluate((element) => {
    const source = element as HTMLCanvasElement;
    const copy = document.createElement("canvas");
    [copy.width, copy.height] = [source.width, source.height];
    const context = copy.getContext("2d");
    if (!context || source.width === 0) return 0;
    context.drawImage(source, 0, 0);
    const { data } = context.getImageData(0, 0, copy.width, copy.height);
    let count = 0;
    for (let index = 3; index < data.length; index += 16) if ((data[index] ?? 0) > 40) count++;
    return count;
  });
}
