// The program and a browser, for tests of the page.
import { execFileSync, spawn } from "node:child_process";
import { existsSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

export const root = fileURLToPath(new URL("../../../../", import.meta.url));
export const program = process.env.TOUCHDOWN ?? join(root, "target/release/touchdown");
const browserPath = process.env.CHROMIUM ?? ["/usr/bin/chromium", "/usr/bin/chromium-browser"].find((path) => existsSync(path));
// WebGL without a graphics card. The page around it is not drawn through WebGL, which would take half of the browser's time again.
const browserOptions = ["--headless=new", "--no-sandbox", "--use-angle=swiftshader-webgl", "--enable-unsafe-swiftshader"];

export const vehicle = "sweeps/vehicles/surveyor-table-4-1.toml";

const sample = `title = "Dispersed touchdowns"
job = "outcome"
vehicle = "${join(root, vehicle)}"
[scene]
slope_deg = 15
friction = 1
[axes]
vertical_velocity_fps = { mean = 14, sd = 0.7 }
horizontal_velocity_fps = { mean = 11, sd = 2.5, from = 0, to = 25 }
cross_slope_deg = { from = 150, to = 210 }
[sample]
design = "sobol"
count = 300
seed = 1966
`;

/** Gathers what a page writes to its console as errors or warnings. @param {import("playwright-core").Page} page @param {string[]} complaints */
export function gather(page, complaints) {
  page.on("console", (message) => {
    // How the browser brings pictures of WebGL into its own is no fault of the page.
    const isOfBrowser = message.text().includes("GPU stall due to ReadPixels");
    if (["error", "warning"].includes(message.type()) && !isOfBrowser) complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(String(error.stack)));
}

/** Starts the program on the Surveyor, a map, a profile and a sample, and a browser. @param {...string} more files */
export async function start(...more) {
  const folder = mkdtempSync(join(tmpdir(), "explorer-"));
  writeFileSync(join(folder, "sample.toml"), sample);
  execFileSync(program, ["sweep", join(folder, "sample.toml"), "--out", folder, "--quiet"], { cwd: root });
  const files = [vehicle, "sweeps/vehicles/four-legs.toml", "results/surface-4-20.csv", "results/figure-4-09.csv", "results/landers/six-legs-map.csv", join(folder, "sample.csv"), ...more];
  const server = spawn(program, ["explore", ...files], { cwd: root });
  const address = await new Promise((resolve, reject) => {
    let text = "";
    server.stdout.on("data", (data) => {
      text += data;
      const found = /http:\/\/\S+/.exec(text);
      if (found) resolve(found[0]);
    });
    server.on("exit", (code) => reject(new Error(`touchdown explore ended with ${code}`)));
    server.stderr.on("data", (data) => process.stderr.write(data));
  });
  const browser = await chromium.launch({ executablePath: browserPath, args: browserOptions });
  /** @type {import("playwright-core").Page | undefined} where pictures are compared */
  let blank;
  /** @type {string[]} */
  const complaints = [];
  return {
    address,
    browser,
    folder,
    /** What pages wrote to their consoles as errors or warnings since the last call. */
    complaints: () => complaints.splice(0),
    /**
     * Opens the page, and waits for the landing.
     * @param {string} [hash]
     * @param {import("playwright-core").BrowserContextOptions} [options]
     * @param {() => void} [script] what runs before the page
     */
    async open(hash = "", options = {}, script = () => {}) {
      // Landings do not play by themselves, so that pictures can be compared.
      const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, acceptDownloads: true, reducedMotion: "reduce", ...options });
      const page = await context.newPage();
      gather(page, complaints);
      await page.addInitScript(script);
      await page.goto(address + hash);
      await page.waitForSelector(".landing-tab .outcome[data-class]", { state: "attached" });
      await calm(page);
      return page;
    },
    /** How many pixels of two pictures differ by more than a shade. @param {Buffer} one @param {Buffer} other */
    async differing(one, other) {
      blank ??= await browser.newPage();
      return blank.evaluate(async (pictures) => {
        const [a, b] = await Promise.all(pictures.map(async (text) => {
          const image = new Image();
          image.src = `data:image/png;base64,${text}`;
          await image.decode();
          const canvas = document.createElement("canvas");
          [canvas.width, canvas.height] = [image.width, image.height];
          const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
          context.drawImage(image, 0, 0);
          return context.getImageData(0, 0, image.width, image.height).data;
        }));
        if (a.length !== b.length) return Infinity;
        let count = 0;
        for (let i = 0; i < a.length; i += 4) {
          if (Math.max(Math.abs(a[i] - b[i]), Math.abs(a[i + 1] - b[i + 1]), Math.abs(a[i + 2] - b[i + 2])) > 8) count += 1;
        }
        return count;
      }, [one, other].map((picture) => picture.toString("base64")));
    },
    async stop() {
      await browser.close();
      server.removeAllListeners("exit");
      server.kill("SIGINT");
      rmSync(folder, { recursive: true, force: true });
    },
  };
}

/**
 * Brushes the scatter plot from one place to another, as parts of its width and height.
 * @param {import("playwright-core").Page} page @param {[number, number]} from @param {[number, number]} to
 */
export async function brush(page, from, to) {
  const canvas = page.locator(".scatter canvas");
  await canvas.scrollIntoViewIfNeeded();
  const box = /** @type {{ x: number, y: number, width: number, height: number }} */ (await canvas.boundingBox());
  await page.mouse.move(box.x + from[0] * box.width, box.y + from[1] * box.height);
  await page.mouse.down();
  await page.mouse.move(box.x + to[0] * box.width, box.y + to[1] * box.height, { steps: 4 });
  await page.mouse.up();
  await page.waitForSelector('.counts[aria-busy="false"]');
}

/** Waits until pictures have been drawn. @param {import("playwright-core").Page} page */
export async function calm(page) {
  await page.waitForTimeout(300);
  await page.evaluate(() => new Promise((resolve) => {
    let left = 4;
    const step = () => ((left -= 1) ? requestAnimationFrame(step) : resolve(undefined));
    requestAnimationFrame(step);
  }));
}

/** Picture of the landing, which says whether it has changed. @param {import("playwright-core").Page} page @param {string} [of] */
export async function picture(page, of = ".landing-tab .stage") {
  // Where the pointer and the keyboard are is no part of the picture.
  await page.mouse.move(0, 0);
  await page.evaluate(() => document.activeElement instanceof HTMLElement && document.activeElement.blur());
  return page.locator(of).first().screenshot();
}

/** How the landing that is shown ended. @param {import("playwright-core").Page} page */
export const outcome = (page) => page.locator(".landing-tab .outcome").getAttribute("data-outcome");

/** Moves a slider, as a hand does. @param {import("playwright-core").Page} page @param {string} name @param {number} value */
export async function slide(page, name, value) {
  await page.locator(`[data-name="${name}"] input[type="range"]`).fill(String(value));
}

/** How `touchdown land --json` ends. @param {...string} options */
export function land(...options) {
  const text = execFileSync(program, ["land", "--vehicle", vehicle, "--json", ...options], { cwd: root, encoding: "utf8" });
  return JSON.parse(text);
}

export const baseline = ["--vertical-velocity", "14", "--cross-slope", "180", "--slope", "15", "--friction", "1"];
