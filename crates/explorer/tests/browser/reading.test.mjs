// Whether everybody can read and use the page: keyboard, large text, dark and light, narrow windows.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { calm, start } from "./harness.mjs";

/** @type {Awaited<ReturnType<typeof start>>} */
let explorer;
before(async () => (explorer = await start()));
after(() => explorer.stop());

const CONTROLS = "a[href], button, input, select, summary, textarea, canvas[tabindex]";

for (const tab of ["Landing", "Map", "Dispersion"]) {
  test(`the keyboard alone reaches every control of ${tab}`, async () => {
    const page = await explorer.open();
    await page.getByRole("tab", { name: "Landing" }).focus();
    while ((await page.locator('[role="tab"][aria-selected="true"]').textContent()) !== tab) await page.keyboard.press("ArrowRight");
    await calm(page);
    await page.waitForTimeout(800);
    const wanted = await page.evaluate((selector) => {
      const all = /** @type {HTMLElement[]} */ ([...document.querySelectorAll(selector)]);
      const shown = all.filter((part) => part.checkVisibility() && !(/** @type {HTMLButtonElement} */ (part).disabled) && part.tabIndex >= 0);
      shown.forEach((part, index) => (part.dataset.reached = String(index)));
      return shown.map((part) => `${part.tagName} ${part.getAttribute("aria-label") ?? part.textContent?.trim()}`);
    }, CONTROLS);
    await page.evaluate(() => document.activeElement instanceof HTMLElement && document.activeElement.blur());
    const reached = new Set();
    for (let i = 0; i < wanted.length + 10; i += 1) {
      await page.keyboard.press("Tab");
      reached.add(await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement)?.dataset.reached));
    }
    assert.deepEqual(wanted.filter((_, index) => !reached.has(String(index))), []);
    await page.context().close();
  });

  test(`text at 200 % does not overflow on ${tab}`, async () => {
    const page = await explorer.open();
    await page.addStyleTag({ content: ":root { font-size: 200% !important; }" }).catch(() => page.evaluate(() => {
      document.documentElement.style.fontSize = "200%";
    }));
    await page.getByRole("tab", { name: tab }).click();
    await page.waitForTimeout(800);
    const wide = await page.evaluate(() => {
      const size = parseFloat(getComputedStyle(document.documentElement).fontSize);
      const { scrollWidth, clientWidth } = document.documentElement;
      const cut = [...document.querySelectorAll("button, label, summary, h1, h2, p, th, td, legend, figcaption")]
        .filter((part) => part.checkVisibility() && part.scrollWidth > part.clientWidth + 2 && getComputedStyle(part).display !== "inline")
        .map((part) => part.textContent);
      return { size, over: scrollWidth - clientWidth, cut };
    });
    assert.deepEqual(wide, { size: 32, over: 0, cut: [] });
    await page.context().close();
  });
}

test("dark and light follow the system, and the switch", async () => {
  for (const colorScheme of /** @type {const} */ (["dark", "light"])) {
    const page = await explorer.open("", { colorScheme });
    const light = () => page.evaluate(() => {
      const [r, g, b] = (getComputedStyle(document.body).backgroundColor.match(/\d+/g) ?? []).map(Number);
      return (r + g + b) / 3;
    });
    const before = await light();
    assert.ok(colorScheme === "dark" ? before < 60 : before > 200, `${colorScheme}: ${before}`);
    await page.getByRole("button", { name: "Light or dark" }).click();
    const after = await light();
    assert.ok(colorScheme === "dark" ? after > 200 : after < 60, `${colorScheme} switched: ${after}`);
    assert.deepEqual(explorer.complaints(), []);
    await page.context().close();
  }
});

test("text has enough contrast in dark and light", async () => {
  for (const colorScheme of /** @type {const} */ (["dark", "light"])) {
    const page = await explorer.open("", { colorScheme });
    const ratios = await page.evaluate(() => {
      const style = getComputedStyle(document.documentElement);
      const luminance = (/** @type {string} */ hex) => {
        const part = (/** @type {number} */ at) => {
          const value = parseInt(hex.slice(at, at + 2), 16) / 255;
          return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
        };
        return 0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5);
      };
      const of = (/** @type {string} */ name) => luminance(style.getPropertyValue(name).trim());
      return ["--text", "--pale", "--accent", "--error", "--warning", "--stable", "--unstable", "--failure"].flatMap((name) =>
        ["--paper", "--panel"].map((under) => {
          const [high, low] = [of(name), of(under)].sort((a, b) => b - a);
          return { pair: `${name} on ${under}`, ratio: (high + 0.05) / (low + 0.05) };
        }));
    });
    for (const { pair, ratio } of ratios) assert.ok(ratio >= 4.4, `${colorScheme}: ${pair} has ${ratio}`);
    await page.context().close();
  }
});

test("a telephone shows the landing first, and the picture beside sliders", async () => {
  const page = await explorer.open("", { viewport: { width: 390, height: 844 }, hasTouch: true });
  const over = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  assert.equal(over, 0);
  const stage = await page.locator(".landing-tab .stage").boundingBox();
  const numbers = await page.locator(".landing-tab .aside").boundingBox();
  assert.ok(stage && numbers && stage.y < numbers.y);
  await page.getByRole("button", { name: "Numbers" }).tap();
  await calm(page);
  for (const part of [".landing-tab .outcome", ".landing-tab .stage", '[data-name="vertical_velocity_fps"] input[type="range"]']) {
    const box = await page.locator(part).boundingBox();
    assert.ok(box && box.y >= -2 && box.y + box.height <= 845, `${part}: ${JSON.stringify(box)}`);
  }
  const picture = await page.locator(".landing-tab .stage").boundingBox();
  const sheet = await page.locator(".landing-tab .aside").boundingBox();
  assert.ok(picture && sheet && picture.y + picture.height <= sheet.y, JSON.stringify([picture, sheet]));
  assert.equal(await page.locator(".landing-tab .stage canvas").evaluate((canvas) => getComputedStyle(canvas).touchAction), "pan-y");
  assert.deepEqual(explorer.complaints(), []);
  await page.context().close();
});
