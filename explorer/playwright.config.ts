import { defineConfig } from "@playwright/test";

/** A free one, which tests/run finds. */
const PORT = process.env["EXPLORER_PORT"] ?? "8391";

/** The system's own browser, which tests/run finds. */
const browser = process.env["CHROMIUM"];

// The page is tested as it is shipped: built, and served by the command with its policy.
export default defineConfig({
  testDir: "tests",
  outputDir: "../.venv/explorer-tests",
  // A page waits for its frames more than it computes.
  fullyParallel: true,
  workers: 2,
  forbidOnly: true,
  // Software draws slowly on a machine that does other things as well.
  timeout: 90_000,
  expect: { timeout: 15_000 },
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
