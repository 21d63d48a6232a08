// Draws the page as it stands in a browser into an SVG, which README.md shows:
//     make explorer && explorer/picture/draw docs/explorer.svg
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, extname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "@playwright/test";

const here = dirname(fileURLToPath(import.meta.url));
const built = resolve(here, "../../src/kugelpendel/cli/explore/page");
const types = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm", ".woff2": "font/woff2", ".svg": "image/svg+xml" };
const [WIDTH, HEIGHT] = [1440, 860];

const executablePath = ["/usr/bin/chromium", "/usr/bin/chromium-browser"].find((path) => existsSync(path));
const browser = await chromium.launch({ ...(executablePath && { executablePath }), args: ["--no-sandbox", "--disable-gpu"] });
const page = await browser.newPage({ viewport: { width: WIDTH, height: HEIGHT }, locale: "en-GB", reducedMotion: "reduce", colorScheme: "light" });
await page.addInitScript({ path: join(here, "recorder.js") });
await page.route("http://explorer.invalid/**", (route) => {
  const path = join(built, new URL(route.request().url()).pathname.replace(/\/$/, "/index.html"));
  return existsSync(path) ? route.fulfill({ body: readFileSync(path), contentType: types[extname(path)] ?? "text/plain" }) : route.abort();
});
await page.goto("http://explorer.invalid/#preset=rosette&t=13.6");
await page.waitForSelector("html[data-ready]");
await page.waitForTimeout(1500);
const body = await page.evaluate(() => {
  const shape = (number) => String(Math.round(number * 10) / 10);
  const escaped = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
  const clear = (color) => /, 0\)$|transparent/.test(color);
  const hex = (color) => `#${(color.match(/\d+/g) ?? []).slice(0, 3).map((one) => Number(one).toString(16).padStart(2, "0")).join("")}`;
  const style = getComputedStyle(document.documentElement);
  const out = [];

  function box(element) {
    const look = getComputedStyle(element);
    const { left, top, width, height } = element.getBoundingClientRect();
    const parent = getComputedStyle(element.parentElement);
    const round = Math.min(Number.parseFloat((parent.overflowX === "hidden" ? parent : look).borderTopLeftRadius) || 0, height / 2);
    const framed = look.borderTopWidth !== "0px" && look.borderBottomWidth !== "0px" && look.borderLeftWidth !== "0px";
    if (!clear(look.backgroundColor) || framed)
      out.push(`<rect x="${shape(left)}" y="${shape(top)}" width="${shape(width)}" height="${shape(height)}" rx="${shape(round)}" fill="${clear(look.backgroundColor) ? "none" : hex(look.backgroundColor)}"${framed ? ` stroke="${hex(look.borderTopColor)}"` : ""}/>`);
    if (framed) return;
    for (const [side, y] of [["Top", top], ["Bottom", top + height - 1]])
      if (look[`border${side}Width`] !== "0px") {
        const dots = look[`border${side}Style`] === "dotted" ? ` stroke-dasharray="2 2"` : "";
        out.push(`<path d="M${shape(left)} ${shape(y)}h${shape(width)}" stroke="${hex(look[`border${side}Color`])}" stroke-width="${Number.parseFloat(look[`border${side}Width`])}"${dots}/>`);
      }
  }

  function words(node) {
    const look = getComputedStyle(node.parentElement);
    const lines = new Map();
    for (const word of node.data.matchAll(/\S+\s*/g)) {
      const range = document.createRange();
      range.setStart(node, word.index);
      range.setEnd(node, word.index + word[0].trimEnd().length);
      const at = range.getBoundingClientRect();
      if (at.width === 0) continue;
      const line = lines.get(Math.round(at.top)) ?? { left: at.left, right: at.right, bottom: at.bottom, top: at.top, text: "" };
      lines.set(Math.round(at.top), { ...line, right: at.right, text: line.text + word[0] });
    }
    for (const { left, right, top, bottom, text } of lines.values()) {
      const size = Number.parseFloat(look.fontSize);
      const y = (top + bottom) / 2 + 0.34 * size;
      const serif = look.fontFamily.includes("Serif 4") ? ` font-family="'Source Serif 4', Georgia, serif"` : "";
      out.push(`<text x="${shape(left)}" y="${shape(y)}" textLength="${shape(right - left)}" lengthAdjust="spacingAndGlyphs" font-size="${size}" font-weight="${look.fontWeight}" fill="${hex(look.color)}"${serif}>${escaped(text.trimEnd())}</text>`);
    }
  }

  function walk(node) {
    if (node.nodeType === Node.TEXT_NODE) return words(node);
    if (!(node instanceof Element) || node.matches(".unseen, .skip, .bob-handle, .drag, .orbit, .stage-foot, [hidden]")) return;
    if (getComputedStyle(node).display === "none") return;
    const { left, top, width, height } = node.getBoundingClientRect();
    if (node instanceof HTMLCanvasElement) {
      const label = node.dataset.layer ?? "";
      out.push(`<svg x="${shape(left)}" y="${shape(top)}" width="${shape(width)}" height="${shape(height)}"${label ? ` class="${label}"` : ""}>${window.recorded(node)}</svg>`);
    } else if (node instanceof SVGElement) {
      const drawing = node.innerHTML.replaceAll(/var\((--[\w-]+)\)/g, (_, name) => style.getPropertyValue(name).trim());
      const color = hex(getComputedStyle(node).color);
      const own = ["fill", "stroke", "stroke-width", "stroke-linecap", "stroke-linejoin"].map((name) => (node.getAttribute(name) ? ` ${name}="${node.getAttribute(name)}"` : "")).join("");
      out.push(`<svg x="${shape(left)}" y="${shape(top)}" width="${shape(width)}" height="${shape(height)}" viewBox="${node.getAttribute("viewBox")}" color="${color}"${own}>${drawing}</svg>`);
    } else {
      box(node);
      for (const child of node.childNodes) walk(child);
    }
  }

  walk(document.querySelector(".page"));
  return out.join("\n");
});
await browser.close();
const paper = "#fdfcf9";
const head = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDTH} ${HEIGHT}" font-family="Inter, 'Segoe UI', Roboto, Helvetica, Arial, sans-serif">`;
writeFileSync(process.argv[2], `${head}\n<rect width="${WIDTH}" height="${HEIGHT}" fill="${paper}"/>\n${body}\n</svg>\n`);
