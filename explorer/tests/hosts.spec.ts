/** The page on other hosts: below a path, from a server that knows nothing, and without a request that leaves it. */
import { createReadStream, existsSync, statSync } from "node:fs";
import { createServer, type Server } from "node:http";
import type { AddressInfo } from "node:net";
import { join, normalize } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, test, type Page } from "@playwright/test";

const PAGE = fileURLToPath(new URL("../../src/kugelpendel/cli/explore/page", import.meta.url));
const BELOW = "/some/where/";

/** As plain as a host gets: no type for WebAssembly, no policy. */
function plainHost(): Server {
  const types: Record<string, string> = { html: "text/html", js: "text/javascript", css: "text/css", svg: "image/svg+xml" };
  return createServer((request, response) => {
    const path = new URL(request.url ?? "", "http://host").pathname;
    const file = join(PAGE, normalize(path.startsWith(BELOW) ? path.slice(BELOW.length) || "index.html" : "none"));
    if (!file.startsWith(PAGE) || !existsSync(file) || !statSync(file).isFile()) {
      response.writeHead(404).end();
      return;
    }
    response.writeHead(200, { "Content-Type": types[file.split(".").at(-1) ?? ""] ?? "application/octet-stream" });
    createReadStream(file).pipe(response);
  });
}

/** What the page asks for and complains of while it opens. */
async function opened(page: Page, address: string): Promise<{ asked: string[]; complaints: string[] }> {
  const [asked, complaints] = [[] as string[], [] as string[]];
  page.on("request", (request) => asked.push(request.url()));
  page.on("pageerror", (error) => complaints.push(String(error)));
  page.on("console", (message) => {
    if (message.type() === "error") complaints.push(message.text());
  });
  const core = page.waitForResponse((response) => response.url().endsWith(".wasm"));
  await page.goto(address);
  await core;
  await expect(page.locator("html")).toHaveAttribute("data-ready", "", { timeout: 25_000 });
  await page.evaluate(() => document.fonts.ready);
  return { asked, complaints };
}

test("under its own server's policy the page opens, and asks for nothing else", async ({ page, baseURL }) => {
  const { asked, complaints } = await opened(page, "./");
  const away = asked.filter((url) => !url.startsWith(baseURL ?? "") && !url.startsWith("data:") && !url.startsWith("blob:"));
  expect(away).toEqual([]);
  expect(complaints).toEqual([]);
});

test("below a path, and without a type for its core, the page opens as well", async ({ page }) => {
  const host = plainHost();
  await new Promise<void>((done) => host.listen(0, "127.0.0.1", done));
  try {
    const { port } = host.address() as AddressInfo;
    const { asked, complaints } = await opened(page, `http://127.0.0.1:${port}${BELOW}`);
    expect(asked.filter((url) => !url.includes(BELOW) && url.startsWith("http"))).toEqual([]);
    expect(complaints).toEqual([]);
  } finally {
    host.closeAllConnections();
    host.close();
  }
});
