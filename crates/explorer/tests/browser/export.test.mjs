import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { after, before, test } from "node:test";
import { baseline, calm, gather, land, picture, program, root, slide, start, vehicle } from "./harness.mjs";

/** @type {Awaited<ReturnType<typeof start>>} */
let explorer;
before(async () => (explorer = await start()));
after(() => explorer.stop());

test("an exported page opens from disk without a network, and lands bit for bit as the program", async () => {
  const file = join(explorer.folder, "page.html");
  execFileSync(program, ["explore", vehicle, "results/figure-4-09.csv", "--export", file], { cwd: root });
  const context = await explorer.browser.newContext({ viewport: { width: 1280, height: 900 }, offline: true });
  const page = await context.newPage();
  /** @type {string[]} */
  const complaints = [];
  /** @type {string[]} */
  const asked = [];
  gather(page, complaints);
  page.on("request", (request) => /^https?:/.test(request.url()) && asked.push(request.url()));
  await page.goto(`${pathToFileURL(file)}#v.horizontal_velocity_fps=11.3&v.roll_deg=7.5`);
  await page.waitForSelector(".landing-tab .outcome[data-class]", { timeout: 30000 });
  // A key, as the page may still move under a pointer.
  await page.locator(".landing-tab .numbers summary").press("Enter");
  await page.waitForSelector(".landing-tab .numbers tr");
  const shown = await page.locator(".landing-tab .numbers tr").evaluateAll((rows) =>
    Object.fromEntries(rows.map((row) => [row.dataset.name, row.querySelector("td")?.title])));
  const { result } = land(...baseline, "--horizontal-velocity", "11.3", "--roll", "7.5");
  for (const [name, value] of Object.entries(result)) assert.equal(shown[name], String(value ?? ""), name);
  await page.waitForFunction(() => document.querySelector(".strip-words")?.textContent?.includes("topples"));
  const before = await picture(page);
  await slide(page, "horizontal_velocity_fps", 13);
  await page.waitForSelector('.landing-tab .outcome[data-class="unstable"]');
  await calm(page);
  assert.ok((await explorer.differing(before, await picture(page))) > 500);
  await page.getByRole("tab", { name: "Map" }).click();
  await page.locator(".map-tab > .boundary canvas").focus();
  await page.waitForTimeout(500);
  const box = /** @type {{ x: number, y: number, width: number, height: number }} */ (await page.locator(".map-tab > .boundary canvas").boundingBox());
  await page.mouse.click(box.x + 0.5 * box.width, box.y + 0.5 * box.height);
  await page.waitForFunction(() => document.querySelectorAll(".pair .outcome[data-class]").length === 2);
  const ends = await page.locator(".pair .outcome").evaluateAll((parts) => parts.map((part) => /** @type {HTMLElement} */ (part).dataset.class));
  assert.deepEqual(ends, ["stable", "unstable"]);
  assert.deepEqual(complaints, []);
  assert.deepEqual(asked, []);
  await context.close();
});
