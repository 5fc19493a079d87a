import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { brush, calm, picture, start } from "./harness.mjs";

/** @type {Awaited<ReturnType<typeof start>>} */
let explorer;
before(async () => (explorer = await start()));
after(() => explorer.stop());

/** @param {import("playwright-core").Page} page */
async function openMap(page) {
  await page.getByRole("tab", { name: "Map" }).click();
  await page.waitForFunction(() => document.querySelector(".map-legend")?.childElementCount);
  await calm(page);
}

/** Ends of the two landings that are shown. @param {import("playwright-core").Page} page */
const ends = (page) => page.locator(".pair .outcome").evaluateAll((parts) => parts.map((part) => /** @type {HTMLElement} */ (part).dataset.class));

test("a click on the map shows two landings with different ends, which play in step", async () => {
  const page = await explorer.open();
  await openMap(page);
  const box = /** @type {{ x: number, y: number, width: number, height: number }} */ (await page.locator(".contour canvas").boundingBox());
  // Straight downhill without roll lies at the bottom, in the middle.
  await page.mouse.click(box.x + 0.5 * box.width, box.y + 0.88 * box.height);
  await page.waitForSelector(".pair .outcome[data-class]");
  await page.waitForFunction(() => document.querySelectorAll(".pair .outcome[data-class]").length === 2);
  assert.deepEqual(await ends(page), ["stable", "unstable"]);
  const reading = (await page.locator(".reading").first().textContent()) ?? "";
  assert.match(reading, /VH = 11\.\d+ ft\/s, above: topples, between 11\.\d+ and 11\.\d+; certain/);
  await page.locator(".pair .timeline input").fill("0.25");
  await calm(page);
  const early = await picture(page, ".pair .stage");
  await page.locator(".pair .timeline input").fill("1");
  await calm(page);
  assert.ok((await explorer.differing(early, await picture(page, ".pair .stage"))) > 500);
  assert.deepEqual(explorer.complaints(), []);
  await page.context().close();
});

test("pointing tells a value, and the surface and the sections are drawn", async () => {
  const page = await explorer.open("#tab=map");
  await openMap(page);
  const before = await page.locator(".reading").first().textContent();
  const box = /** @type {{ x: number, y: number, width: number, height: number }} */ (await page.locator(".contour canvas").boundingBox());
  await page.mouse.move(box.x + 0.55 * box.width, box.y + 0.7 * box.height);
  await page.waitForFunction((text) => document.querySelector(".reading")?.textContent !== text, before);
  const surface = await picture(page, ".surface");
  await page.locator(".surface canvas").focus();
  const place = /** @type {{ x: number, y: number }} */ (await page.locator(".surface canvas").boundingBox());
  await page.mouse.move(place.x + 200, place.y + 200);
  await page.mouse.down();
  await page.mouse.move(place.x + 320, place.y + 240, { steps: 4 });
  await page.mouse.up();
  await calm(page);
  assert.ok((await explorer.differing(surface, await picture(page, ".surface"))) > 500);
  await page.getByLabel("Axis up").selectOption("roll_deg");
  await page.waitForFunction(() => /** @type {HTMLSelectElement} */ (document.querySelector('[aria-label="Axis across"]')).value === "cross_slope_deg");
  assert.deepEqual(explorer.complaints(), []);
  await page.context().close();
});

test("the keyboard goes from point to point of the map and lands", async () => {
  const page = await explorer.open("#tab=map");
  await openMap(page);
  await page.locator(".contour canvas").focus();
  for (const key of ["ArrowDown", "ArrowDown", "ArrowRight", "Enter"]) await page.keyboard.press(key);
  await page.waitForSelector(".pair .outcome[data-class]", { state: "attached" });
  assert.deepEqual(explorer.complaints(), []);
  await page.context().close();
});

test("a link restores a point of a profile, and its landing is explored further", async () => {
  const page = await explorer.open("#tab=map&results=figure-4-09&at=10");
  await page.waitForFunction(() => document.querySelectorAll(".pair .outcome[data-class]").length === 2);
  assert.deepEqual(await ends(page), ["stable", "unstable"]);
  await page.getByRole("button", { name: "Explore the landing above" }).click();
  await page.waitForSelector('.landing-tab .outcome[data-class="unstable"]');
  assert.equal(await page.locator('[data-name="roll_deg"] input[type="text"]').inputValue(), "10");
  assert.deepEqual(explorer.complaints(), []);
  await page.context().close();
});

test("landings of a sample are selected and replayed", async () => {
  const page = await explorer.open("#tab=dispersion");
  await page.waitForSelector(".counts td");
  await brush(page, [0.2, 0.2], [0.6, 0.6]);
  const caption = (await page.locator(".counts caption").textContent()) ?? "";
  const count = Number(/^(\d+) of 300/.exec(caption)?.[1]);
  assert.ok(count > 20 && count < 280, caption);
  const counts = await page.locator(".counts tr").evaluateAll((rows) => rows.map((row) => [...row.querySelectorAll("td")].map((cell) => cell.textContent ?? "")));
  const [stable, share, interval] = counts[0];
  const [low, high] = (/^([\d.]+) to ([\d.]+) %$/.exec(interval) ?? []).slice(1).map(Number);
  assert.ok(low < parseFloat(share) && parseFloat(share) < high && Math.abs(parseFloat(share) - (100 * Number(stable)) / count) < 0.5, counts[0].join());
  await page.locator(".scatter canvas").focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Enter");
  await page.waitForSelector(".sample-tab .outcome[data-class]");
  const told = /Landing 2, ([a-z0-9-]+):/.exec((await page.locator(".sample-tab .reading").textContent()) ?? "")?.[1];
  assert.equal(await page.locator(".sample-tab .outcome").getAttribute("data-outcome"), told);
  assert.deepEqual(explorer.complaints(), []);
  await page.context().close();
});

test("a shipped map has values at its points, and landings that are refused leave no verdict", async () => {
  const page = await explorer.open("#tab=map&results=six-legs-map&at=180,0");
  await page.waitForFunction(() => document.querySelectorAll(".pair .outcome[data-class]").length === 2);
  const shades = await page.locator(".contour canvas").evaluate((/** @type {HTMLCanvasElement} */ canvas) => {
    const { data } = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d")).getImageData(0, 0, 0.85 * canvas.width, canvas.height);
    const seen = new Map();
    for (let i = 0; i < data.length; i += 4) {
      const shade = [data[i], data[i + 1], data[i + 2]].join();
      seen.set(shade, (seen.get(shade) ?? 0) + 1);
    }
    return [...seen.values()].filter((count) => count > 150).length;
  });
  assert.ok(shades > 8, `${shades} shades`);
  await page.route("**/api/at", (route) => route.abort());
  // The map has its place once all below it is there.
  await calm(page);
  const box = /** @type {{ x: number, y: number, width: number, height: number }} */ (await page.locator(".contour canvas").boundingBox());
  await page.mouse.click(box.x + 0.3 * box.width, box.y + 0.5 * box.height);
  await page.waitForFunction(() => [...document.querySelectorAll(".pair .outcome")].every((part) => /** @type {HTMLElement} */ (part).dataset.class === "none"));
  explorer.complaints();
  await page.context().close();
});

test("a brush and the landing that was chosen survive a reload", async () => {
  const page = await explorer.open("#tab=dispersion");
  await page.waitForSelector(".counts td");
  await brush(page, [0.2, 0.2], [0.6, 0.6]);
  const caption = await page.locator(".counts caption").textContent();
  await page.locator(".scatter canvas").focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Enter");
  await page.waitForSelector(".sample-tab .outcome[data-class]");
  await page.waitForFunction(() => location.hash.includes("brush=") && location.hash.includes("landing=2"));
  await page.reload();
  await page.waitForSelector(".sample-tab .outcome[data-class]");
  await page.waitForFunction((wanted) => document.querySelector(".counts caption")?.textContent === wanted, caption);
  assert.match((await page.locator(".sample-tab .reading").textContent()) ?? "", /^Landing 2,/);
  await page.getByLabel("Units").selectOption("SI");
  await page.waitForFunction(() => /m\/s/.test(document.querySelector(".sample-tab .reading")?.textContent ?? ""));
  await page.waitForFunction((wanted) => document.querySelector(".counts caption")?.textContent === wanted, caption);
  assert.deepEqual(explorer.complaints(), []);
  await page.context().close();
});

test("maps, their sections and landings, and samples are in the units of the page", async () => {
  const page = await explorer.open("#tab=map&at=180,0");
  await page.waitForFunction(() => document.querySelectorAll(".pair .outcome[data-class]").length === 2);
  await page.getByLabel("Units").selectOption("SI");
  await page.waitForFunction(() => document.querySelector(".reading")?.textContent?.includes("m/s"));
  assert.match((await page.locator(".reading").first().textContent()) ?? "", /roll angle Ξ 0 deg: VH = 3\.4746\d* m\/s/i);
  assert.match((await page.locator(".map-legend").textContent()) ?? "", /stable up to 7.62 m\/s/);
  assert.match((await page.locator(".conditions").textContent()) ?? "", /vertical velocity 4.2672 m\/s/);
  await page.waitForFunction(() => [...document.querySelectorAll(".pair .stage-legend")].every((part) => /1 m is \d+ N/.test(part.textContent ?? "")));
  await page.getByRole("tab", { name: "Dispersion" }).click();
  await page.waitForSelector(".counts td");
  assert.match((await page.getByLabel("Across", { exact: true }).locator("option:checked").textContent()) ?? "", /m\/s$/);
  assert.deepEqual(explorer.complaints(), []);
  await page.context().close();
});

test("a section runs as the map above it, and legends explain its marks", async () => {
  const page = await explorer.open("#tab=map&at=180,0");
  await page.waitForFunction(() => document.querySelectorAll(".pair .outcome[data-class]").length === 2);
  const reading = () => page.locator(".reading").first().textContent();
  const rollAt = async (/** @type {string} */ of, /** @type {number} */ y) => {
    const canvas = page.locator(of).first();
    await canvas.scrollIntoViewIfNeeded();
    const box = /** @type {{ x: number, y: number, width: number, height: number }} */ (await canvas.boundingBox());
    await page.mouse.move(box.x + 0.25 * box.width, box.y + y * box.height);
    return Number(/roll angle Ξ (.\d*)/i.exec((await reading())?.replace("−", "-") ?? "")?.[1]);
  };
  const [onMap, inSection] = [await rollAt(".contour canvas", 0.85), await rollAt(".sections canvas", 0.5)];
  assert.ok(onMap > 10 && inSection > 10, `${onMap} and ${inSection}`);
  assert.match((await page.locator(".map-legend").textContent()) ?? "", /sections: VH, above it: topples/);
  assert.match((await page.locator(".pair .stage-legend").first().textContent()) ?? "", /from it to the CG.*ground below extended footpads/);
  assert.doesNotMatch((await reading()) ?? "", /; above/);
  await page.context().close();
});
