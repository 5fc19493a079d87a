import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { baseline, calm, land, outcome, picture, slide, start } from "./harness.mjs";

/** @type {Awaited<ReturnType<typeof start>>} */
let explorer;
before(async () => (explorer = await start("sweeps/vehicles/apollo-like.toml")));
after(() => explorer.stop());

test("the page loads without complaints and shows a landing with its histories", async () => {
  const page = await explorer.open();
  assert.equal(await outcome(page), "stable-subsided");
  assert.ok((await page.locator(".landing-tab .chart").count()) >= 8);
  // Charts are drawn when they come into sight.
  await page.locator(".landing-tab .chart").last().scrollIntoViewIfNeeded();
  await page.waitForSelector(".landing-tab .chart:last-child canvas");
  await page.evaluate(() => window.scrollTo(0, 0));
  await page.waitForFunction(() => document.querySelector(".strip-words")?.textContent?.includes("topples"));
  // Four corners and the middle of the picture are not one colour: something has been drawn.
  const colours = await page.evaluate(() => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector(".landing-tab .stage canvas"));
    return new Promise((resolve) => requestAnimationFrame(() => {
      const copy = document.createElement("canvas");
      [copy.width, copy.height] = [32, 32];
      const context = /** @type {CanvasRenderingContext2D} */ (copy.getContext("2d"));
      canvas.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft", bubbles: true }));
      requestAnimationFrame(() => {
        context.drawImage(canvas, 0, 0, 32, 32);
        resolve(new Set(new Uint32Array(context.getImageData(0, 0, 32, 32).data.buffer)).size);
      });
    }));
  });
  assert.ok(colours > 20, `${colours} colours`);
  assert.deepEqual(explorer.complaints(), []);
  await page.context().close();
});

test("a slider changes the outcome and the picture", async () => {
  const page = await explorer.open();
  const before = await picture(page);
  await slide(page, "horizontal_velocity_fps", 12);
  await page.waitForSelector('.landing-tab .outcome[data-outcome="unstable-pitch"]');
  await calm(page);
  assert.ok((await explorer.differing(before, await picture(page))) > 500);
  await slide(page, "horizontal_velocity_fps", 8);
  await page.waitForSelector('.landing-tab .outcome[data-outcome="stable-subsided"]');
  assert.deepEqual(explorer.complaints(), []);
  await page.context().close();
});

test("while a slider moves histories wait, and they follow when it rests", async () => {
  const page = await explorer.open();
  /** @type {{ history?: boolean }[]} */
  const asked = [];
  page.on("request", (request) => request.url().endsWith("api/landing") && asked.push(request.postDataJSON()));
  const wereStale = page.evaluate(() => new Promise((resolve) => {
    const curves = /** @type {HTMLElement} */ (document.querySelector(".landing-tab .histories"));
    new MutationObserver(() => curves.classList.contains("stale") && resolve(true)).observe(curves, { attributes: true });
  }));
  await page.locator('[data-name="horizontal_velocity_fps"] input[type="range"]').evaluate((/** @type {HTMLInputElement} */ range) => {
    range.value = "12";
    range.dispatchEvent(new Event("input", { bubbles: true }));
  });
  assert.ok(await wereStale);
  await page.waitForSelector(".landing-tab .histories:not(.stale)");
  assert.equal(await outcome(page), "unstable-pitch");
  assert.deepEqual(asked.map(({ history }) => history), [false, true]);
  await page.context().close();
});

test("a number of the vehicle changes the landing, and goes back", async () => {
  const page = await explorer.open("#v.horizontal_velocity_fps=11.25");
  await page.getByPlaceholder("Search numbers").fill("strut preload");
  const row = page.locator('[data-name="vehicle.strut.preload_lb"]');
  await row.locator('input[type="text"]').fill("300");
  await row.locator('input[type="text"]').press("Enter");
  const wanted = land(...baseline, "--horizontal-velocity", "11.25", "--set", "vehicle.strut.preload_lb=300").result;
  await page.waitForFunction((end) => document.querySelector(".landing-tab .outcome")?.textContent?.includes(`${end} s`), wanted.end_time_s.toFixed(3));
  await row.locator(".back").click();
  const usual = land(...baseline, "--horizontal-velocity", "11.25").result;
  await page.waitForFunction((end) => document.querySelector(".landing-tab .outcome")?.textContent?.includes(`${end} s`), usual.end_time_s.toFixed(3));
  assert.equal(await row.locator('input[type="text"]').inputValue(), "185");
  await page.context().close();
});

test("numbers are those of touchdown land, digit for digit, and short ones with their units are shown", async () => {
  const page = await explorer.open("#v.horizontal_velocity_fps=11.3&v.roll_deg=7.5");
  await page.locator(".landing-tab .numbers summary").press("Enter");
  await page.waitForSelector(".landing-tab .numbers tr");
  const shown = await page.locator(".landing-tab .numbers tr").evaluateAll((rows) =>
    Object.fromEntries(rows.map((row) => [row.dataset.name, row.querySelector("td")?.title])));
  const { result } = land(...baseline, "--horizontal-velocity", "11.3", "--roll", "7.5");
  assert.deepEqual(Object.keys(shown), Object.keys(result));
  for (const [name, value] of Object.entries(result)) assert.equal(shown[name], String(value ?? ""), name);
  const text = (await page.locator('.landing-tab .numbers [data-name="min_clearance_ft"] td').textContent()) ?? "";
  assert.match(text, /^\d\.\d{1,6} ft$/);
  await page.context().close();
});

test("numbers out of range are told beside the slider in the words of the command line", async () => {
  const page = await explorer.open();
  const row = page.locator('[data-name="slope_deg"]');
  await row.locator('input[type="text"]').fill("95");
  await row.locator('input[type="text"]').press("Enter");
  const complaint = row.locator(".complaint");
  await page.waitForFunction(() => document.querySelector('[data-name="slope_deg"] .complaint')?.textContent);
  assert.match((await complaint.textContent()) ?? "", /slope_deg.*95.*90/);
  await row.locator('input[type="text"]').fill("10");
  await row.locator('input[type="text"]').press("Enter");
  await page.waitForFunction(() => document.querySelector('[data-name="slope_deg"] .complaint')?.textContent === "");
  // What the browser writes of a refused request is no complaint of the page.
  assert.deepEqual(explorer.complaints().filter((text) => !text.includes("status of 400")), []);
  await page.context().close();
});

test("play reaches the end, and time, histories and picture go together", async () => {
  const page = await explorer.open("#v.horizontal_velocity_fps=12");
  const end = await page.locator(".landing-tab .clock").textContent();
  await page.getByLabel("Speed").first().selectOption("1");
  const atEnd = await picture(page);
  await page.getByRole("button", { name: "Play" }).first().click();
  await page.waitForFunction(() => {
    const time = parseFloat(document.querySelector(".landing-tab .clock")?.textContent ?? "");
    return time > 0.2 && time < 1;
  });
  await page.waitForSelector('.landing-tab .play[aria-label="Play"]', { timeout: 20000 });
  assert.equal(await page.locator(".landing-tab .clock").textContent(), end);
  await calm(page);
  assert.equal(await explorer.differing(atEnd, await picture(page)), 0);
  const [slider] = await page.locator(".landing-tab .timeline input").all();
  await slider.fill("0.3");
  await calm(page);
  assert.ok((await explorer.differing(atEnd, await picture(page))) > 500);
  const shift = await page.locator(".landing-tab .time-cursor").first().evaluate((cursor) => cursor.style.transform);
  assert.match(shift, /translateX\(\d+/);
  await page.context().close();
});

test("a landing plays once by itself, unless motion is reduced", async () => {
  // Noted from the start on: on a slow machine it has ended before a test sees the page.
  const page = await explorer.open("", { reducedMotion: "no-preference" }, () => {
    const times = new Set();
    Object.assign(window, { times });
    const note = () => times.add(document.querySelector(".landing-tab .clock")?.textContent);
    new MutationObserver(note).observe(document, { subtree: true, childList: true, characterData: true });
  });
  await page.waitForSelector('.landing-tab .play[aria-label="Play"]');
  const seen = await page.evaluate(() => /** @type {any} */ (window).times.size);
  assert.ok(Number(seen) > 3, `${seen} times`);
  assert.match((await page.locator(".landing-tab .hint").textContent()) ?? "", /Drag anything/);
  const still = await explorer.open();
  assert.equal(await still.locator(".landing-tab .play").getAttribute("aria-label"), "Play");
  await page.context().close();
  await still.context().close();
});

test("ground under a leg is a rock or a pit", async () => {
  const pictures = [];
  for (const height of [0, 0.6, -0.6]) {
    const page = await explorer.open(`#v.footing[1].height_ft=${height}&t=0`);
    pictures.push(await picture(page));
    await page.context().close();
  }
  for (const [index, one] of pictures.entries()) {
    for (const other of pictures.slice(index + 1)) assert.ok((await explorer.differing(one, other)) > 500);
  }
  assert.deepEqual(explorer.complaints(), []);
});

test("another vehicle begins with a touchdown that it survives, and fills the picture", async () => {
  const page = await explorer.open();
  await page.locator("#source").selectOption("four-legs");
  await page.waitForFunction(() => location.hash.includes("source=four-legs"));
  await calm(page);
  assert.equal(await page.locator(".landing-tab .outcome").getAttribute("data-class"), "stable");
  const chosen = await picture(page);
  const linked = await explorer.open("#source=four-legs");
  assert.ok((await explorer.differing(chosen, await picture(linked))) < 2000);
  assert.deepEqual(explorer.complaints(), []);
  await page.context().close();
  await linked.context().close();
});

test("a lander has the charts of its own struts, and none of blocks that it has not", async () => {
  const titles = async (/** @type {string} */ source) => {
    const page = await explorer.open(`#source=${source}`);
    await calm(page);
    const charts = page.locator(".landing-tab .chart");
    const all = [];
    // Charts are drawn when they come into sight.
    for (let chart = 0; chart < (await charts.count()); chart += 1) {
      await charts.nth(chart).scrollIntoViewIfNeeded();
      await charts.nth(chart).locator("canvas").first().waitFor();
      all.push(await charts.nth(chart).locator("figcaption").textContent());
    }
    await page.context().close();
    return all.join("; ");
  };
  assert.match(await titles("apollo-like"), /Strut stroke.*Secondary struts' load.*Secondary struts' stroke/);
  const hinged = await titles("four-legs");
  assert.doesNotMatch(hinged, /Secondary|Block/);
  assert.deepEqual(explorer.complaints(), []);
});

test("Back goes to what was shown before a step, and a reload keeps what is shown", async () => {
  const page = await explorer.open("#v.horizontal_velocity_fps=12");
  await page.waitForFunction(() => location.hash.includes("v.horizontal_velocity_fps=12"));
  await page.waitForTimeout(400);
  await page.getByRole("button", { name: "Give back all numbers of the input" }).click();
  await page.waitForSelector('.landing-tab .outcome[data-outcome="stable-subsided"]');
  await page.waitForFunction(() => !location.hash.includes("v."));
  await page.goBack();
  await page.waitForSelector('.landing-tab .outcome[data-outcome="unstable-pitch"]');
  await page.reload();
  await page.waitForSelector('.landing-tab .outcome[data-outcome="unstable-pitch"]');
  assert.deepEqual(explorer.complaints(), []);
  await page.context().close();
});

test("views from uphill, side and top differ, and the keyboard turns the camera", async () => {
  const page = await explorer.open();
  const pictures = [];
  for (const view of ["View from uphill", "View from the side", "View from above"]) {
    await page.getByRole("button", { name: view }).first().click();
    await calm(page);
    pictures.push(await picture(page));
  }
  await page.locator(".landing-tab .stage canvas").focus();
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("ArrowRight");
  await calm(page);
  pictures.push(await picture(page));
  for (const [index, one] of pictures.entries()) {
    for (const other of pictures.slice(index + 1)) assert.ok((await explorer.differing(one, other)) > 500);
  }
  await page.context().close();
});

test("the strip has a handle, and bands with their certainty are found", async () => {
  const page = await explorer.open();
  await page.getByLabel("Horizontal velocity V_H").last().waitFor({ state: "attached" });
  await page.locator('.strip-line input[type="range"]').fill("15");
  await page.waitForSelector('.landing-tab .outcome[data-class="unstable"]');
  await page.getByRole("button", { name: "Find the bands exactly" }).click();
  await page.waitForFunction(() => document.querySelector(".strip-words")?.textContent?.includes("(certain)"), undefined, { timeout: 60000 });
  assert.match((await page.locator(".strip-words").textContent()) ?? "", /stable 0 to 11\.3.*; \d+ landings below 11\.3\d+ are stable/);
  await page.context().close();
});

test("the address restores what is shown", async () => {
  const page = await explorer.open();
  await slide(page, "horizontal_velocity_fps", 12);
  await page.waitForSelector('.landing-tab .outcome[data-outcome="unstable-pitch"]');
  await page.getByRole("button", { name: "View from the side" }).first().click();
  await page.locator(".landing-tab .timeline input").fill("0.4");
  await page.waitForFunction(() => location.hash.includes("t=0.4") && location.hash.includes("view=side"));
  const hash = await page.evaluate(() => location.hash);
  await calm(page);
  const before = await picture(page);
  const again = await explorer.open(hash);
  await again.waitForFunction(() => document.querySelector(".landing-tab .clock")?.textContent === "0.400 s");
  assert.equal(await outcome(again), "unstable-pitch");
  await calm(again);
  assert.equal(await explorer.differing(before, await picture(again)), 0);
  assert.deepEqual(explorer.complaints(), []);
  await page.context().close();
  await again.context().close();
});

test("the page asks for a landing and its numbers once", async () => {
  const page = await explorer.open();
  /** @type {string[]} */
  const asked = [];
  page.on("request", (request) => asked.push(request.url().split("/").slice(4).join("/")));
  await page.reload();
  await page.waitForFunction(() => document.querySelector(".strip-words")?.textContent?.includes("topples"));
  await calm(page);
  for (const name of ["inputs", "parameters", "landing"]) assert.deepEqual(asked.filter((url) => url === `api/${name}`).length, 1, name);
  assert.deepEqual(asked.filter((url, index) => !url.startsWith("api/") && asked.indexOf(url) !== index), []);
  await page.context().close();
});

test("units change numbers and titles", async () => {
  const page = await explorer.open();
  await page.getByLabel("Units").selectOption("SI");
  await page.waitForFunction(() => [...document.querySelectorAll(".chart strong")].some((title) => title.textContent === "Clearance, m"));
  const row = page.locator('[data-name="vertical_velocity_fps"]');
  assert.equal(await row.locator(".unit").textContent(), "m/s");
  assert.equal(await row.locator('input[type="text"]').inputValue(), "4.2672");
  assert.match((await page.locator(".landing-tab .stage-legend").textContent()) ?? "", /arrows: 1 m is \d+ N/);
  assert.deepEqual(explorer.complaints(), []);
  await page.context().close();
});

test("the link to the landing keeps the numbers that were set", async () => {
  const page = await explorer.open("#v.horizontal_velocity_fps=12");
  await page.locator("#skip").focus();
  await page.keyboard.press("Enter");
  await calm(page);
  assert.equal(await page.evaluate(() => document.activeElement?.id), "content");
  assert.equal(await outcome(page), "unstable-pitch");
  assert.match(await page.evaluate(() => location.hash), /v\.horizontal_velocity_fps=12/);
  await page.context().close();
});

test("a refused number takes the verdict away, and giving it back brings it again", async () => {
  const page = await explorer.open();
  const row = page.locator('[data-name="slope_deg"]');
  for (const text of ["95", "steep"]) {
    await row.locator('input[type="text"]').fill(text);
    await row.locator('input[type="text"]').press("Enter");
    await page.waitForSelector('.landing-tab .outcome[data-class="none"]');
    assert.match((await page.locator(".landing-tab .outcome").textContent()) ?? "", new RegExp(`^no landing.*slope_deg.*${text}`));
    assert.equal(await page.locator(".landing-tab .numbers").isVisible(), false);
    await row.locator(".back").click();
    await page.waitForSelector('.landing-tab .outcome[data-outcome="stable-subsided"]');
  }
  await page.context().close();
});

test("a link to a refused number says so, and its number can be changed", async () => {
  const page = await explorer.open("#v.slope_deg=95");
  await page.waitForSelector('.landing-tab .outcome[data-class="none"]');
  const field = page.locator('[data-name="slope_deg"] input[type="text"]');
  await field.waitFor();
  assert.equal(await field.inputValue(), "95");
  await field.fill("10");
  await field.press("Enter");
  await page.waitForSelector('.landing-tab .outcome[data-class="stable"]');
  await page.context().close();
});

test("a link names what is not there", async () => {
  const page = await explorer.open("#source=nowhere&tab=else&results=lost&v.slope_deg=10");
  const said = (await page.locator("#trouble").textContent()) ?? "";
  for (const name of ['input "nowhere"', 'tab "else"', 'results "lost"', "surveyor-table-4-1"]) assert.ok(said.includes(name), `${name}: ${said}`);
  assert.equal(await page.locator("#trouble").isVisible(), true);
  assert.equal(await page.getByRole("tab", { name: "Landing" }).getAttribute("aria-selected"), "true");
  await slide(page, "horizontal_velocity_fps", 12);
  await page.waitForSelector('.landing-tab .outcome[data-outcome="unstable-pitch"]');
  assert.equal(await page.locator("#trouble").isVisible(), false);
  await page.context().close();
});

test("a program that has ended leaves no verdict", async () => {
  const page = await explorer.open();
  await page.route("**/api/**", (route) => route.abort());
  await slide(page, "horizontal_velocity_fps", 12);
  await page.waitForSelector('.landing-tab .outcome[data-class="none"]');
  assert.match((await page.locator(".landing-tab .outcome").textContent()) ?? "", /the program does not answer/);
  explorer.complaints();
  await page.context().close();
});

test("a landing that goes on beyond its verdict tells when the verdict fell", async () => {
  const page = await explorer.open("#v.horizontal_velocity_fps=12&v.solver.stop=time");
  const { end_time_s } = land(...baseline, "--horizontal-velocity", "12").result;
  const text = (await page.locator(".landing-tab .outcome").textContent()) ?? "";
  assert.ok(text.includes(`unstable-pitch at ${end_time_s.toFixed(3)} s`), text);
  await page.context().close();
});

test("a button beside the transport lets the landing go on beyond its verdict, and ends it there again", async () => {
  const page = await explorer.open("#v.horizontal_velocity_fps=12");
  const { end_time_s } = land(...baseline, "--horizontal-velocity", "12").result;
  const going = page.getByRole("button", { name: "Go on beyond the verdict" });
  assert.equal(await going.getAttribute("aria-pressed"), "false");
  await going.click();
  await page.waitForSelector('.transport button[aria-pressed="true"]');
  // It plays on from the verdict.
  await page.waitForFunction((end) => parseFloat(document.querySelector(".landing-tab .clock")?.textContent ?? "") > end, end_time_s);
  assert.match((await page.locator(".landing-tab .outcome").textContent()) ?? "", /unstable-pitch at .* shown to/);
  await page.waitForFunction(() => location.hash.includes("v.solver.stop=time"));
  await going.click();
  await page.waitForSelector('.transport button[aria-pressed="false"]');
  assert.doesNotMatch((await page.locator(".landing-tab .outcome").textContent()) ?? "", /shown to/);
  assert.deepEqual(explorer.complaints(), []);
  await page.context().close();
});

test("landings that are kept lie in the charts under others, in the address, and are removed", async () => {
  const page = await explorer.open("#v.horizontal_velocity_fps=11.2");
  const captions = () => page.locator(".landing-tab .chart").first().locator("figcaption span").allTextContents();
  assert.equal((await captions()).length, 1);
  const keep = page.getByRole("button", { name: "Keep this landing" });
  await keep.click();
  await page.waitForSelector(".kept li");
  await slide(page, "horizontal_velocity_fps", 12);
  await page.waitForSelector('.landing-tab .outcome[data-outcome="unstable-pitch"]');
  await slide(page, "roll_deg", 10);
  await page.waitForFunction(() => location.hash.includes("v.roll_deg=10"));
  await keep.click();
  await page.waitForFunction(() => document.querySelectorAll(".kept li").length === 2);
  await slide(page, "vertical_velocity_fps", 10);
  const names = ["Roll angle Ξ 0 deg", "Vertical velocity VV 14 ft/s"];
  await page.waitForFunction((wanted) => wanted.every((name) => document.querySelector(".kept")?.textContent?.includes(name)), names);
  const [present, first, second] = await captions();
  assert.match(present, /^σ /);
  assert.match(first, /^Vertical velocity VV 14 ft\/s, Horizontal velocity VH 11.2 ft\/s, Roll angle Ξ 0 deg /);
  assert.match(second, /^Vertical velocity VV 14 ft\/s /);

  // The readings of a landing that is kept are its own.
  await page.locator(".landing-tab .timeline input").fill("0.4");
  const history = JSON.parse(await page.evaluate(async () => {
    const request = { touchdown: { values: { horizontal_velocity_fps: 11.2 } }, drawing: false };
    const answer = await fetch("api/landing", { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(request) });
    return answer.text();
  })).history.columns;
  const value = (/** @type {string} */ name) => history.find((/** @type {{ name: string }} */ column) => column.name === name).values[40];
  assert.equal(value("t_s"), 0.4);
  assert.equal(Number(/([^ ]+)$/.exec((await captions())[1])?.[1]), Number(value("sigma_deg").toPrecision(4)));

  await page.waitForFunction(() => location.hash.includes("keep=") && location.hash.includes("t=0.4"));
  const linked = await explorer.open(await page.evaluate(() => location.hash));
  await linked.waitForFunction(() => document.querySelectorAll(".kept li").length === 2);
  await linked.getByLabel("Units").selectOption("SI");
  await linked.waitForFunction(() => document.querySelector(".kept")?.textContent?.includes("4.2672 m/s"));
  await linked.getByRole("button", { name: /^Remove .*Horizontal/ }).click();
  await linked.waitForFunction(() => document.querySelectorAll(".kept li").length === 1);
  await linked.waitForFunction(() => document.querySelectorAll(".landing-tab .chart:first-child figcaption span").length === 2);
  assert.deepEqual(explorer.complaints(), []);
  await page.context().close();
  await linked.context().close();
});
