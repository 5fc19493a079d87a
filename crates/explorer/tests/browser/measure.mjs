// How fast the page is: frames a second while a landing plays, and the time from an input to its picture. Prints a line of JSON.
import { start } from "./harness.mjs";

const explorer = await start();
const page = await explorer.open("#v.horizontal_velocity_fps=11.3");

/** @param {number[]} values */
const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];

const intervals = await page.evaluate(async () => {
  const press = /** @type {HTMLButtonElement} */ (document.querySelector(".landing-tab .play"));
  const speed = /** @type {HTMLSelectElement} */ (document.querySelector(".landing-tab .transport select"));
  speed.value = "0.5";
  speed.dispatchEvent(new Event("change"));
  press.click();
  /** @type {number[]} */
  const times = [];
  await new Promise((resolve) => {
    const frame = (/** @type {number} */ now) => {
      times.push(now);
      if (press.getAttribute("aria-label") === "Pause") requestAnimationFrame(frame);
      else resolve(undefined);
    };
    requestAnimationFrame(frame);
  });
  return times.slice(1).map((time, index) => time - times[index]);
});

/** From an input to the second frame after its landing is known: by then its picture has been drawn. */
const latencies = await page.evaluate(async () => {
  const range = /** @type {HTMLInputElement} */ (document.querySelector('[data-name="roll_deg"] input[type="range"]'));
  const outcome = /** @type {HTMLElement} */ (document.querySelector(".landing-tab .outcome"));
  const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
  /** @type {number[]} */
  const times = [];
  for (let step = 1; step <= 60; step += 1) {
    await new Promise((resolve) => setTimeout(resolve, 60));
    const shown = new Promise((resolve) => new MutationObserver((_, observer) => {
      observer.disconnect();
      resolve(undefined);
    }).observe(outcome, { childList: true }));
    const began = performance.now();
    range.value = String(step % 30);
    range.dispatchEvent(new Event("input", { bubbles: true }));
    await shown;
    await frame();
    await new Promise((resolve) => setTimeout(resolve));
    times.push(performance.now() - began);
  }
  return times;
});

const seconds = intervals.reduce((sum, interval) => sum + interval, 0) / 1000;
console.log(JSON.stringify({
  frames_per_second: Math.round(intervals.length / seconds),
  longest_frame_ms: Math.round(Math.max(...intervals)),
  input_to_picture_median_ms: Math.round(median(latencies)),
  input_to_picture_slowest_ms: Math.round(Math.max(...latencies)),
}));
await explorer.stop();
