import { colours } from "../look/theme.js";
import { font, textScale, writeWords } from "../look/text.js";
import { label, roundValues } from "../look/words.js";

/** @typedef {{ low: number, high: number }} Ends */

/**
 * Draws the grid, the numbers and the titles of a chart, and tells where values lie in it.
 * @param {CanvasRenderingContext2D} context
 * @param {{ left: number, top: number, width: number, height: number }} area
 * @param {[Ends, Ends]} ends across and up
 * @param {[string, string]} titles
 */
export function frame(context, { left, top, width, height }, ends, titles) {
  const now = colours();
  const share = (/** @type {number} */ axis, /** @type {number} */ value) => (value - ends[axis].low) / (ends[axis].high - ends[axis].low);
  const x = (/** @type {number} */ value) => left + share(0, value) * width;
  const y = (/** @type {number} */ value) => top + (1 - share(1, value)) * height;
  context.fillStyle = now.text;
  context.strokeStyle = now.grid;
  context.lineWidth = 1;
  context.font = font(12);
  context.textAlign = "center";
  context.textBaseline = "top";
  for (const value of roundValues(ends[0].low, ends[0].high, width / (70 * textScale()))) {
    context.strokeRect(x(value), top, 0, height);
    context.fillText(label(value), x(value), top + height + 6);
  }
  context.textAlign = "right";
  context.textBaseline = "middle";
  for (const value of roundValues(ends[1].low, ends[1].high, height / (40 * textScale()))) {
    context.strokeRect(left, y(value), width, 0);
    context.fillText(label(value), left - 6, y(value));
  }
  context.textAlign = "center";
  writeWords(context, titles[0], left + 0.5 * width, top + height + 32 * textScale());
  context.save();
  context.translate(14 * textScale(), top + 0.5 * height);
  context.rotate(-Math.PI / 2);
  writeWords(context, titles[1], 0, 0);
  context.restore();
  return { x, y };
}
