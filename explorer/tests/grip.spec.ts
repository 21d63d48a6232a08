import { expect, test, type Page } from "@playwright/test";
import { drawn, open } from "./page";

test.use({ locale: "en-GB", contextOptions: { reducedMotion: "reduce" }, viewport: { width: 1280, height: 800 } });

async function middle(page: Page, selector: string): Promise<{ x: number; y: number }> {
  // It stands where it belongs only after the first frame.
  await expect(page.locator(selector)).toHaveAttribute("style", /translate/);
  const box = (await page.locator(selector).boundingBox())!;
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

test("the bob is pulled aside, shows its first swing, and goes when it is let go", async ({ page }) => {
  const errors = await open(page);
  const { x, y } = await middle(page, ".bob-handle");
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 60, y + 10, { steps: 6 });
  await expect(page.locator(".pull-flag")).toContainText("°");
  await expect(page.locator(".push-flag")).toContainText("Push 50.0 cm/s");
  expect(await drawn(page, "[data-layer=over]")).toBeGreaterThan(50);
  // Held still for longer than a flick looks back.
  await page.waitForTimeout(150);
  await page.mouse.move(x - 60, y + 11);
  await page.waitForTimeout(120);
  await page.mouse.up();
  await expect(page.locator(".title")).toHaveText("Your own launch");
  await expect(page.getByRole("button", { name: "Pause" })).toBeVisible();
  await expect(page.locator(".hint")).toBeHidden();
  expect(new URL(page.url()).hash).toContain("launch.kind=plane");
  expect(errors).toEqual([]);
});

test("Escape while it is held leaves all as it was, and Back undoes a launch", async ({ page }) => {
  await open(page);
  const { x, y } = await middle(page, ".bob-handle");
  await page.locator(".bob-handle").focus();
  await page.keyboard.press("Space");
  await page.keyboard.press("ArrowUp");
  await expect(page.locator(".pull-flag")).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(page.locator(".title")).toHaveText("The ellipse that turns");
  await expect(page.locator(".given")).toContainText("45.0 cm");
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 80, y, { steps: 5 });
  await page.mouse.up();
  await expect(page.locator(".title")).toHaveText("Your own launch");
  await page.goBack();
  await expect(page.locator(".title")).toHaveText("The ellipse that turns");
});

test("a flick gives the bob the speed of the hand", async ({ page }) => {
  await open(page);
  // Sixteen events 5 ms apart, with times of their own: a busy machine hands out a mouse's one by one.
  await page.locator(".bob-handle").evaluate((handle) => {
    handle.setPointerCapture = () => undefined;
    const { left, top } = handle.getBoundingClientRect();
    const tell = (type: string, step: number): void => {
      const event = new PointerEvent(type, { bubbles: true, pointerId: 7, button: 0, buttons: 1, clientX: left + 28 - 4 * step, clientY: top + 28 });
      Object.defineProperty(event, "timeStamp", { value: 1000 + 5 * step });
      handle.dispatchEvent(event);
    };
    tell("pointerdown", 0);
    for (let step = 1; step <= 16; step++) tell("pointermove", step);
    tell("pointerup", 16);
  });
  await expect(page.locator(".title")).toHaveText("Your own launch");
  await expect(page.locator(".given")).toContainText("then pushed");
  await expect(page.locator(".given")).not.toContainText("50.0 cm/s");
});

test("keys do what the pointer does: pull, push, let go; what is held is spoken", async ({ page }) => {
  await open(page);
  await page.locator(".bob-handle").focus();
  await page.keyboard.press("Space");
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("ArrowRight");
  await expect(page.locator("[data-live]")).toContainText("push 56.3 cm/s");
  await page.keyboard.press("Shift+ArrowRight");
  await expect(page.locator(".push-flag")).toContainText("56.9 cm/s");
  await page.keyboard.press("Space");
  await expect(page.getByRole("button", { name: "Pause" })).toBeVisible();
});

test("the arrow is dragged at its tip", async ({ page }) => {
  await open(page);
  await page.locator(".bob-handle").focus();
  await page.keyboard.press("Space");
  const { x, y } = await middle(page, ".push-handle");
  const bob = await middle(page, ".bob-handle");
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 0.5 * (x - bob.x), y + 0.5 * (y - bob.y), { steps: 4 });
  await page.mouse.up();
  const text = (await page.locator(".push-flag").textContent())!;
  expect(Number(/[\d.]+/.exec(text)?.[0])).toBeGreaterThan(60);
});

test("the bob is dragged in the plan, too, and an empty stage turns the view", async ({ page }) => {
  await open(page);
  const { x, y } = await middle(page, ".plan .drag");
  const plan = (await page.locator(".plan canvas").boundingBox())!;
  expect([x > plan.x, x < plan.x + plan.width, y > plan.y, y < plan.y + plan.height]).toEqual([true, true, true, true]);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 30, y + 20, { steps: 4 });
  await page.mouse.up();
  await expect(page.locator(".title")).toHaveText("Your own launch");
  await page.getByRole("button", { name: "Pause" }).click();
  const before = await middle(page, ".bob-handle");
  const stage = (await page.locator(".stage").boundingBox())!;
  await page.mouse.move(stage.x + 30, stage.y + 60);
  await page.mouse.down();
  await page.mouse.move(stage.x + 130, stage.y + 60, { steps: 4 });
  await page.mouse.up();
  await expect.poll(async () => Math.abs((await middle(page, ".bob-handle")).x - before.x)).toBeGreaterThan(3);
});

test("on the turning ground the bob is let go without a push, where it has been pulled to", async ({ page }) => {
  await open(page, "preset=pantheon");
  const { x, y } = await middle(page, ".plan .drag");
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 20, y + 15, { steps: 4 });
  await page.mouse.up();
  await expect(page.locator(".title")).toHaveText("Your own launch");
  const link = new URL(page.url()).hash;
  expect(link).toContain("launch.kind=ellipse");
  expect(link).toContain("launch.b=0");
  expect(link).toContain("launch.azimuth=");
});
