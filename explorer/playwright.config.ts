import { existsSync } from "node:fs";
import { defineConfig } from "@playwright/test";

const PORT = 8391;

/** Debian's and Ubuntu's names of the browser. */
const browser = ["/usr/bin/chromium", "/usr/bin/chromium-browser"].find((path) => existsSync(path));

// The page is tested as it is shipped: built, and served by the command with its policy.
export default defineConfig({
  testDir: "tests",
  outputDir: "../.venv/explorer-tests",
  workers: 1,
  forbidOnly: true,
  reporter: [["line"]],
  use: {
    baseURL: `http://127.0.0.1:${PORT}/`,
    launchOptions: { ...(browser ? { executablePath: browser } : {}), args: ["--no-sandbox", "--disable-gpu"] },
  },
  webServer: {
    command: `../.venv/bin/kugelpendel explore --no-browser --port ${PORT}`,
    url: `http://127.0.0.1:${PORT}/`,
    reuseExistingServer: false,
  },
});
