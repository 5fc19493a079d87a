// Maps that are computed from the page.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { after, before, test } from "node:test";
import { calm, gather, picture, program, root, start, vehicle } from "./harness.mjs";

/** @type {Awaited<ReturnType<typeof start>>} */
let explorer;
before(async () => (explorer = await start()));
after(() => explorer.stop());

/** Asks for a map over cross-slope and roll. @param {import("playwright-core").Page} page @param {number} side */
async function begin(page, side) {
  const fields = { "up from": 160, "up to": 180, "across from": -20, "across to": 20 };
  for (const [name, value] of Object.entries(fields)) await page.getByLabel(`New map: ${name}`, { exact: true }).fill(String(value));
  await page.getByLabel("New map: points").selectOption(String(side));
  await page.getByRole("button", { name: "Start" }).click();
}

/** @param {import("playwright-core").Page} page @param {RegExp} words */
const told = (page, words) => page.waitForFunction((source) => new RegExp(source).test(document.querySelector(".map-form [role=status]")?.textContent ?? ""), words.source, { timeout: 120000 });

test("a map of the present touchdown fills in, and is the table that a sweep writes", async () => {
  const page = await explorer.open("#tab=map&v.friction=0.9");
  await page.waitForFunction(() => document.querySelector(".map-legend")?.childElementCount);
  await page.getByText("Compute a map").click();
  await page.waitForFunction(() => /** @type {HTMLInputElement} */ (document.querySelector('[aria-label="New map: up from"]')).value);
  await begin(page, 5);
  // The coarse grid is drawn while the finer one is computed.
  await told(page, /of 25 points; 3 × 3 are drawn/);
  const coarse = await picture(page, ".contour");
  await told(page, /^25 points are computed/);
  await calm(page);
  assert.ok((await explorer.differing(coarse, await picture(page, ".contour"))) > 500);
  assert.match((await page.locator(".conditions").textContent()) ?? "", /friction 0.9/);

  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Table, CSV" }).click()]);
  const [head, ...rows] = readFileSync(await download.path(), "utf8").trimEnd().split("\n");
  const sweep = join(explorer.folder, "computed.toml");
  writeFileSync(sweep, `title = "The same"
vehicle = "${join(root, vehicle)}"
[scene]
vertical_velocity_fps = 14
slope_deg = 15
friction = 0.9
[axes]
cross_slope_deg = { from = 160, to = 180, step = 5 }
roll_deg = { from = -20, to = 20, step = 10 }
[search]
from_fps = 0
to_fps = 25
scan_step_fps = 0.25
tolerance_fps = 0.001
`);
  execFileSync(program, ["sweep", sweep, "--out", explorer.folder, "--quiet"], { cwd: root });
  const [wanted, ...known] = readFileSync(join(explorer.folder, "computed.csv"), "utf8").trimEnd().split("\n");
  assert.equal(head, wanted);
  assert.deepEqual(rows, known);

  // A point of it lands on both sides of the boundary, and its landing is explored further.
  await page.locator(".contour canvas").focus();
  for (const key of ["ArrowDown", "Enter"]) await page.keyboard.press(key);
  await page.waitForFunction(() => document.querySelectorAll(".pair .outcome[data-class]").length === 2);
  await page.getByRole("button", { name: "Explore the landing above" }).click();
  await page.waitForSelector('.landing-tab .outcome[data-class="unstable"]');
  assert.equal(await page.locator('[data-name="friction"] input[type="text"]').inputValue(), "0.9");
  assert.deepEqual(explorer.complaints(), []);
  await page.context().close();
});

test("a map that is stopped stays as far as it is, and what is refused is said", async () => {
  const page = await explorer.open("#tab=map");
  await page.getByText("Compute a map").click();
  await page.waitForFunction(() => /** @type {HTMLInputElement} */ (document.querySelector('[aria-label="New map: up from"]')).value);
  await begin(page, 33);
  await told(page, /; 3 × 3 are drawn/);
  await page.getByRole("button", { name: "Stop" }).click();
  await told(page, /^stopped; \d+ × \d+ points are drawn/);
  assert.equal(await page.getByLabel("Results").inputValue(), "");
  await page.getByLabel("New map: up", { exact: true }).selectOption("slope_deg");
  await page.getByLabel("New map: up to").fill("95");
  await page.getByRole("button", { name: "Start" }).click();
  await told(page, /slope_deg = 95.*expected/);
  await page.getByLabel("Results").selectOption("figure-4-09");
  await page.waitForFunction(() => document.querySelector(".map-tab h2")?.textContent?.includes("Figure 4-9"));
  await page.context().close();
});

test("an exported page computes a map too", async () => {
  const file = join(explorer.folder, "bare.html");
  execFileSync(program, ["explore", vehicle, "--export", file], { cwd: root });
  const context = await explorer.browser.newContext({ viewport: { width: 1280, height: 900 }, offline: true });
  const page = await context.newPage();
  /** @type {string[]} */
  const complaints = [];
  gather(page, complaints);
  await page.goto(`${pathToFileURL(file)}#tab=map`);
  await page.waitForFunction(() => /** @type {HTMLInputElement} */ (document.querySelector('[aria-label="New map: up from"]'))?.value, undefined, { timeout: 30000 });
  await begin(page, 5);
  await told(page, /^25 points are computed/);
  assert.match((await page.locator(".map-legend").textContent()) ?? "", /lowest VH/);
  assert.deepEqual(complaints, []);
  await context.close();
});
