import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { baseline, land, program, root, start, vehicle } from "./harness.mjs";

/** @type {Awaited<ReturnType<typeof start>>} */
let explorer;
before(async () => (explorer = await start()));
after(() => explorer.stop());

/** @param {import("playwright-core").Page} page @param {string} name @param {number} [count] */
async function take(page, name, count = 1) {
  /** @type {import("playwright-core").Download[]} */
  const files = [];
  const all = new Promise((resolve) => page.on("download", (file) => files.push(file) === count && resolve(undefined)));
  await page.getByRole("button", { name, exact: true }).click();
  await all;
  return Promise.all(files.map(async (file) => ({ name: file.suggestedFilename(), bytes: readFileSync(await file.path()) })));
}

test("scene file, command and histories repeat the landing", async () => {
  const page = await explorer.open("#v.horizontal_velocity_fps=11.3&v.roll_deg=7.5");
  await page.getByText("Take away").click();
  const { result } = land(...baseline, "--horizontal-velocity", "11.3", "--roll", "7.5");
  const files = await take(page, "Scene file", 2);
  const folder = join(explorer.folder, "scene");
  mkdirSync(folder);
  for (const { name, bytes } of files) writeFileSync(join(folder, name), bytes);
  const scene = /** @type {{ name: string, bytes: Buffer }} */ (files.find(({ bytes }) => bytes.includes("[scene]")));
  execFileSync(program, ["land", join(folder, scene.name), "--out", join(folder, "out")], { cwd: root });
  const [header, row] = readFileSync(join(folder, "out", scene.name.replace(/toml$/, "csv")), "utf8").split("\n");
  assert.equal(row.split(",")[header.split(",").indexOf("end_time_s")], String(result.end_time_s));

  await page.getByRole("button", { name: "Command", exact: true }).click();
  await page.waitForFunction(() => /** @type {HTMLTextAreaElement} */ (document.querySelector(".take textarea")).value);
  const command = await page.locator(".take textarea").inputValue();
  assert.match(command, /^touchdown land /);
  const said = execFileSync("sh", ["-c", `${command.replace(/^touchdown/, program)} --json`], { cwd: root, encoding: "utf8" });
  assert.deepEqual(JSON.parse(said).result, result);

  const [histories] = await take(page, "Histories, CSV");
  const path = join(explorer.folder, "history.csv");
  execFileSync(program, ["land", "--vehicle", vehicle, ...baseline, "--horizontal-velocity", "11.3", "--roll", "7.5", "--history", path], { cwd: root });
  assert.equal(histories.bytes.toString(), readFileSync(path, "utf8"));
  assert.deepEqual(explorer.complaints(), []);
  await page.context().close();
});

test("pictures and the animation are files", async () => {
  const page = await explorer.open("#tab=map");
  await page.waitForFunction(() => document.querySelector(".map-legend")?.childElementCount);
  await page.waitForTimeout(500);
  await page.getByText("Take away").click();
  const [mapPng] = await take(page, "Map, PNG");
  assert.equal(mapPng.bytes.toString("latin1", 1, 4), "PNG");
  for (const name of ["Map, SVG", "Surface, SVG", "Histories, SVG"]) {
    const [svg] = await take(page, name);
    const text = svg.bytes.toString();
    assert.match(text, /^<svg [^>]*width="\d{3,}/);
    assert.ok(!text.includes("NaN") && text.length > 20000, name);
  }
  await page.keyboard.press("Escape");
  await page.getByRole("tab", { name: "Landing" }).click();
  await page.getByText("Take away").click();
  const [png] = await take(page, "Picture, PNG");
  assert.ok(png.bytes.length > 50000);
  const [svg] = await take(page, "Picture, SVG");
  assert.ok(svg.bytes.includes("downhill") && !svg.bytes.includes("NaN"));
  await page.getByLabel("Speed").first().selectOption("1");
  const [movie] = await take(page, "Animation, WebM");
  // The signature of EBML, in which WebM is written.
  assert.equal(movie.bytes.toString("hex", 0, 4), "1a45dfa3");
  assert.ok(movie.bytes.length > 30000, `${movie.bytes.length} bytes`);
  assert.deepEqual(explorer.complaints(), []);
  await page.context().close();
});
