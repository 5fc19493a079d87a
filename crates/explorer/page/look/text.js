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
