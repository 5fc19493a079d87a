// Dispersions: colours, bins and files of what is selected.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { brush, start } from "./harness.mjs";

/** @type {Awaited<ReturnType<typeof start>>} */
let explorer;
before(async () => (explorer = await start()));
after(() => explorer.stop());

/** Rows of a table of bins: landings, those selected, and the texts of classes. @param {import("playwright-core").Page} page */
const bins = (page) => page.locator(".bins tbody tr").evaluateAll((rows) => rows.map((row) => [...row.querySelectorAll("td")].map((cell) => cell.textContent ?? "")));

test("points are coloured by any column, with a scale and its units", async () => {
  const page = await explorer.open("#tab=dispersion");
  await page.waitForSelector('.counts[aria-busy="false"]');
  const before = await page.locator(".scatter").screenshot();
  assert.equal(await page.locator(".colour-scale").count(), 0);
  await page.getByLabel("Colour", { exact: true }).selectOption("vertical_velocity_fps");
  const scale = () => page.locator(".colour-scale").textContent();
  const [, low, high] = /ft\/s: ([\d.]+?\d\d?\.?\d*)(1\d\.\d+)$/.exec((await scale()) ?? "") ?? [];
  assert.ok(Number(low) < 14 && Number(high) > 14, (await scale()) ?? "");
  assert.equal(await page.locator(".colour-scale i").count(), 12);
  assert.ok((await explorer.differing(before, await page.locator(".scatter").screenshot())) > 300);
  await page.waitForFunction(() => location.hash.includes("colour=vertical_velocity_fps"));
  await page.reload();
  await page.waitForSelector(".colour-scale i");
  await page.getByLabel("Units").selectOption("SI");
  await page.waitForFunction(() => document.querySelector(".colour-scale")?.textContent?.includes("m/s"));
  assert.deepEqual(explorer.complaints(), []);
  await page.context().close();
});

test("bins of any column count all landings and those selected, with the intervals of their probabilities", async () => {
  const page = await explorer.open("#tab=dispersion");
  await page.waitForSelector('.counts[aria-busy="false"]');
  await page.locator(".bins summary").press("Enter");
  await page.waitForSelector(".bins tbody tr");
  const whole = await bins(page);
  const sum = (/** @type {string[][]} */ rows, /** @type {number} */ column) => rows.reduce((all, cells) => all + Number(cells[column]), 0);
  assert.deepEqual([sum(whole, 0), sum(whole, 1)], [300, 300]);
  const picture = await page.locator(".bins-chart").screenshot();
  await brush(page, [0.2, 0.2], [0.6, 0.6]);
  const selected = Number(/^(\d+) of 300/.exec((await page.locator(".counts caption").textContent()) ?? "")?.[1]);
  const brushed = await bins(page);
  assert.deepEqual([sum(brushed, 0), sum(brushed, 1)], [300, selected]);
  assert.ok((await explorer.differing(picture, await page.locator(".bins-chart").screenshot())) > 300);
  const filled = /** @type {string[]} */ (brushed.find((cells) => Number(cells[1]) > 3));
  const [share, low, high] = (/^([\d.]+) % \(([\d.]+) to ([\d.]+) %\)$/.exec(filled[2]) ?? []).slice(1).map(Number);
  assert.ok(low <= share && share <= high && high - low < 100, filled.join());
  await page.getByLabel("Bins of").selectOption("end_time_s");
  await page.waitForFunction(() => document.querySelector(".bins thead")?.textContent?.startsWith("End time"));
  assert.equal(sum(await bins(page), 1), selected);
  await page.waitForFunction(() => location.hash.includes("bins=end_time_s"));
  await page.reload();
  await page.waitForSelector('.counts[aria-busy="false"]');
  assert.equal(await page.getByLabel("Bins of").inputValue(), "end_time_s");
  assert.deepEqual(explorer.complaints(), []);
  await page.context().close();
});

test("what is selected is a file: rows of the table as they are written", async () => {
  const page = await explorer.open("#tab=dispersion");
  await page.waitForSelector('.counts[aria-busy="false"]');
  await brush(page, [0.2, 0.2], [0.6, 0.6]);
  const selected = Number(/^(\d+) of 300/.exec((await page.locator(".counts caption").textContent()) ?? "")?.[1]);
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Selected landings, CSV" }).click()]);
  assert.equal(download.suggestedFilename(), "sample-selected.csv");
  const [head, ...rows] = readFileSync(await download.path(), "utf8").trimEnd().split("\n");
  const [all, ...known] = readFileSync(join(explorer.folder, "sample.csv"), "utf8").trimEnd().split("\n");
  assert.equal(head, all);
  assert.equal(rows.length, selected);
  assert.ok(rows.every((row) => known.includes(row)));
  assert.deepEqual(explorer.complaints(), []);
  await page.context().close();
});
