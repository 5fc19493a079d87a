/** Sizes of text on canvases, which follow the size of text that the reader has chosen. */

/** How much larger than usual text is. */
export function textScale() {
  return parseFloat(getComputedStyle(document.documentElement).fontSize) / 16 || 1;
}

/** A font for a canvas. @param {number} size pixels at the usual size of text */
export const font = (size) => `${Math.round(size * textScale() * 10) / 10}px system-ui, "DejaVu Sans", sans-serif`;

/** Room around a chart, as wide as its text wants. @template {Record<string, number>} R @param {R} room @returns {R} */
export function scaled(room) {
  const scale = textScale();
  return /** @type {R} */ (Object.fromEntries(Object.entries(room).map(([side, size]) => [side, size * scale])));
}

/** Writes V_H and V_V with their subscripts. @param {CanvasRenderingContext2D} context @param {string} text @param {number} x @param {number} y */
export function writeWords(context, text, x, y) {
  const runs = text.split(/\bV_([HV])\b/).flatMap((run, index) => (index % 2 ? [{ run: "V", isLow: false }, { run, isLow: true }] : [{ run, isLow: false }]));
  const usual = context.font;
  const size = parseFloat(usual);
  const low = usual.replace(/^[\d.]+px/, `${0.72 * size}px`);
  const align = context.textAlign;
  const widths = runs.map(({ run, isLow }) => {
    context.font = isLow ? low : usual;
    return context.measureText(run).width;
  });
  const whole = widths.reduce((sum, width) => sum + width, 0);
  let left = x - (align === "center" ? 0.5 : align === "right" ? 1 : 0) * whole;
  context.textAlign = "left";
  for (const [index, { run, isLow }] of runs.entries()) {
    context.font = isLow ? low : usual;
    context.fillText(run, left, isLow ? y + 0.25 * size : y);
    left += widths[index];
  }
  context.textAlign = align;
  context.font = usual;
}
