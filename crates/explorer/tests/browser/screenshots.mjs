// Pictures of the page for the documentation, written to docs/pictures.
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { brush, calm, root, start } from "./harness.mjs";

const folder = join(root, "docs/pictures");
mkdirSync(folder, { recursive: true });
const explorer = await start("sweeps/vehicles/apollo-like.toml");
const viewport = { width: 1240, height: 860 };

/**
 * @param {string} name
 * @param {string} hash
 * @param {"light" | "dark"} colorScheme
 * @param {(page: import("playwright-core").Page) => Promise<void>} act
 */
async function shoot(name, hash, colorScheme, act) {
  const page = await explorer.open(hash, { viewport, colorScheme });
  await act(page);
  await page.waitForTimeout(800);
  await calm(page);
  await page.screenshot({ path: join(folder, `${name}.png`) });
  await page.context().close();
}

const strip = (/** @type {import("playwright-core").Page} */ page) =>
  page.waitForFunction(() => document.querySelector(".strip-words")?.textContent?.includes("topples"));

await shoot("explorer-landing", "#v.horizontal_velocity_fps=11.25&t=0.28", "light", async (page) => {
  await strip(page);
});
await shoot("explorer-landing-dark", "#v.horizontal_velocity_fps=12&v.roll_deg=10", "dark", async (page) => {
  await strip(page);
});
await shoot("explorer-cantilever", "#source=apollo-like&units=SI&v.slope_deg=12&v.horizontal_velocity_mps=1.2&t=0.5", "light", async (page) => {
  await page.waitForFunction(() => document.querySelector(".strip-words")?.textContent?.includes("bottoms"));
});
await shoot("explorer-map", "#tab=map&at=152.5,-10", "light", async (page) => {
  await page.waitForFunction(() => document.querySelectorAll(".pair .outcome[data-class]").length === 2);
});
await shoot("explorer-pair", "#tab=map&at=152.5,-10", "light", async (page) => {
  await page.waitForFunction(() => document.querySelectorAll(".pair .outcome[data-class]").length === 2);
  await page.locator(".pair .timeline input").fill("3");
  await page.locator(".pair").evaluate((part) => part.scrollIntoView());
});
await shoot("explorer-dispersion", "#tab=dispersion", "light", async (page) => {
  await page.waitForSelector(".counts td");
  await brush(page, [0.35, 0.15], [0.75, 0.6]);
  await page.locator(".scatter canvas").focus();
  for (const key of ["ArrowUp", "ArrowRight", "Enter"]) await page.keyboard.press(key);
  await page.waitForSelector(".sample-tab .outcome[data-class]");
});
await explorer.stop();
