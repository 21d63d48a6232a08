import { expect, test } from "@playwright/test";
import { de } from "../src/words/de";
import { en } from "../src/words/en";
import { drawn, open } from "./page";

test.use({ locale: "de-DE", contextOptions: { reducedMotion: "reduce" }, viewport: { width: 1280, height: 800 } });

test("a garbled link gives the rosette and a notice, and none of it becomes markup", async ({ page }) => {
  const asked: string[] = [];
  page.on("request", (request) => asked.push(request.url()));
  await open(page, "pendulum.length=%3Cimg%20src%3Dx%20onerror%3Dalert(1)%3E&preset=https://example.org");
  await expect(page.locator(".notice")).toContainText("Der Link war unvollständig. Gezeigt wird die Rosette.");
  await expect(page.locator(".title")).toHaveText("Die Ellipse, die sich dreht");
  expect(await page.locator("img").count()).toBe(0);
  expect(asked.filter((address) => !address.startsWith("http://127.0.0.1:"))).toEqual([]);
  await page.getByRole("button", { name: "Schließen" }).click();
  await expect(page.locator(".notice")).toBeHidden();
});

test("a link that the core refuses gives the rosette as well", async ({ page }) => {
  await open(page, "pendulum.length=1&launch.kind=ellipse&launch.a=2&launch.b=0");
  await expect(page.locator(".notice")).toContainText("Die Auslenkung a = 2 m passt nicht auf die untere Hälfte einer Kugel vom Radius 1 m;");
  await expect(page.locator(".notice")).toContainText("Gezeigt wird die Rosette.");
  await expect(page.locator(".title")).toHaveText("Die Ellipse, die sich dreht");
});

test("the language is the browser's, and a link may say another", async ({ page }) => {
  await open(page, "lang=en");
  await expect(page.locator(".title")).toHaveText("The ellipse that turns");
});

test("where the core is slow or cannot run the page says so, and keeps what it shows", async ({ page }) => {
  let fail = (): void => undefined;
  const failing = new Promise<void>((done) => (fail = done));
  await page.route("**/*.wasm", (route) => failing.then(() => route.abort()));
  await page.goto("./");
  const hint = page.locator(".hint:visible");
  await expect(hint).toHaveText("Der Rechenkern lädt …");
  fail();
  await expect(hint).toContainText("Dieser Browser kann den Rechenkern nicht ausführen.");
  await expect(page.locator(".title:visible")).toHaveText("Die Ellipse, die sich dreht");
  await expect(page.getByRole("link", { name: "Woher sie kommt" })).toHaveAttribute("href", "derivation.de.html#eq-25");
});

test("without a program the page says in both languages what it says of its first example, and shows its rosette", async ({ page, browser }) => {
  const errors = await open(page);
  const still = await browser.newPage({ javaScriptEnabled: false });
  await still.goto("./");
  expect((await still.locator(".stage > svg").boundingBox())?.height).toBeGreaterThan(300);
  const plain = (texts: string[]): string[] => texts.map((text) => text.replaceAll(/\s+/g, " ").trim());
  for (const language of ["de", "en"] as const) {
    if (language === "en") await page.getByRole("button", { name: "English" }).click();
    const said = still.locator(`.first .text > [lang=${language}]`);
    await expect(said.locator("noscript p")).toBeVisible();
    await expect(said.locator("noscript p")).toHaveText({ de, en }[language].first.needs);
    for (const part of [".title", ".preset-text", ".sentence", ".formula-note"]) {
      const shown = plain(await said.locator(part).allTextContents());
      expect(shown.length).toBeGreaterThan(0);
      expect(shown, part).toEqual(plain(await page.locator(`.text ${part}`).allTextContents()));
    }
  }
  await still.close();
  expect(errors).toEqual([]);
});

test("a kiosk has no links and no way out, asks whether somebody is there, and begins again", async ({ page }) => {
  await page.clock.install();
  await page.goto("./#kiosk=1&preset=cone");
  await page.clock.runFor(1000);
  await expect(page.locator(".title")).toHaveText("Im Kreis");
  expect(await page.locator("a[href]:not(.skip)").count()).toBe(0);
  await expect(page.getByRole("button", { name: "Teilen" })).toHaveCount(0);
  // Languages and modes stand within reach of a child as well.
  await page.locator(".within-reach").getByRole("button", { name: "English" }).click();
  await expect(page.locator(".within-reach").getByRole("button", { name: "Pendulum" })).toHaveAttribute("aria-pressed", "true");
  await page.getByRole("button", { name: "Rosette" }).click();
  await page.clock.fastForward(46_000);
  await expect(page.locator(".still")).toHaveText("Still there? It starts again in a moment.");
  await page.mouse.click(640, 300);
  await expect(page.locator(".still")).toBeHidden();
  await page.clock.fastForward(46_000);
  await expect(page.locator(".still")).toBeVisible();
  await page.clock.fastForward(16_000);
  await expect(page.locator(".title")).toHaveText("Im Kreis");
  expect(await page.evaluate(() => !document.dispatchEvent(new MouseEvent("contextmenu", { cancelable: true, bubbles: true })))).toBe(true);
});

test("nobody leaves a kiosk but by holding Escape down for three seconds", async ({ page }) => {
  await page.clock.install();
  await page.goto("./#kiosk=1");
  await page.clock.runFor(500);
  await expect(page.locator("html")).toHaveAttribute("data-kiosk", "");
  await page.keyboard.down("Escape");
  await page.clock.fastForward(2900);
  await page.keyboard.up("Escape");
  await page.clock.fastForward(2900);
  await expect(page.locator("html")).toHaveAttribute("data-kiosk", "");
  await page.keyboard.down("Escape");
  await page.clock.fastForward(3100);
  await expect(page.locator("html")).not.toHaveAttribute("data-kiosk", "");
  await expect(page.getByRole("button", { name: "Teilen" })).toBeVisible();
  expect(page.url()).not.toContain("kiosk");
});

test("every width has room for all, without scrolling sideways", async ({ page }) => {
  // Distances of three digits take the most room.
  await open(page, "preset=cone");
  const wide = (): Promise<number> =>
    page.evaluate(() => {
      const side = document.querySelector(".side")!;
      return Math.max(document.documentElement.scrollWidth - window.innerWidth, side.scrollWidth - side.clientWidth);
    });
  for (const [width, height] of [[1600, 900], [1024, 768], [900, 600], [844, 390], [390, 844], [360, 640]] as const) {
    await page.setViewportSize({ width, height });
    await expect.poll(wide, { message: String(width) }).toBeLessThanOrEqual(0);
    await expect.poll(() => drawn(page, "[data-layer=floor]"), { message: String(width) }).toBeGreaterThan(500);
  }
  await page.setViewportSize({ width: 900, height: 600 });
  await page.getByRole("button", { name: "Beispiele" }).click();
  await page.getByRole("button", { name: "Rosette" }).click();
  await expect(page.locator(".title")).toHaveText("Die Ellipse, die sich dreht");
});

test("what is tapped is 44 px large on a phone", async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await open(page);
  await page.getByRole("button", { name: /^Länge/ }).click();
  const small = await page.evaluate(() =>
    [...document.querySelectorAll("button, a[href], [role=slider]")]
      .filter((one) => one.getClientRects().length > 0 && !one.matches(".skip, .only-wide"))
      .map((one) => {
        const after = getComputedStyle(one, "::after");
        const { width, height } = one.getBoundingClientRect();
        return { what: one.className + one.textContent, width, height: Math.max(height, Number.parseFloat(after.height) || 0) };
      })
      .filter(({ width, height }) => height < 43.5 || width < 24),
  );
  // A link within a sentence is as high as its line, which has 44 px.
  expect(small.filter(({ what }) => what !== "Woher sie kommt")).toEqual([]);
});
