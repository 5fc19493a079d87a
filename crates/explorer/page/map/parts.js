/** Maps whose slow axis has a hole, such as cross-slopes from −180 to −80 and from 80 to 180, are shown part by part. */

/** @typedef {import("../engine/types.js").MapAnswer} MapAnswer */

/** A step so many times as wide as the median one is a hole. */
const HOLE = 5;

/** First and last row of every part. @param {MapAnswer} map @returns {[number, number][]} */
export function partsOf(map) {
  const slow = map.axes[0].values;
  if (!map.grid || slow.length < 4) return [[0, slow.length - 1]];
  const steps = slow.slice(1).map((value, index) => value - slow[index]);
  const median = [...steps].sort((a, b) => a - b)[steps.length >> 1];
  /** @type {[number, number][]} */
  const parts = [];
  let first = 0;
  for (const [index, step] of steps.entries()) {
    // A part without a cell is no part.
    if (step <= HOLE * median || index === first || index + 2 >= slow.length) continue;
    parts.push([first, index]);
    first = index + 1;
  }
  return [...parts, [first, slow.length - 1]];
}

/** A map with nothing but some rows of its grid. @param {MapAnswer} map @param {[number, number]} rows @returns {MapAnswer} */
export function partOf(map, [first, last]) {
  const [slow, ...others] = map.axes;
  if (!map.grid || (first === 0 && last === slow.values.length - 1)) return map;
  const values = slow.values.slice(first, last + 1);
  const [low, high] = [values[0], values[values.length - 1]];
  const isIn = (/** @type {number} */ value) => value >= low && value <= high;
  return {
    ...map,
    axes: [{ ...slow, values }, ...others],
    points: map.points.filter(({ place }) => isIn(place[0])),
    lowest: map.lowest.filter(([at]) => isIn(at)),
    grid: { speeds: map.grid.speeds.slice(first, last + 1) },
    bisector: map.bisector.map((line) => line.filter(([at]) => isIn(at))),
    jump_bars: map.jump_bars.filter((bar) => bar.every(([at]) => isIn(at))),
    jump_cells: map.jump_cells
      .filter(([row]) => row >= first && row < last)
      .map(([row, column]) => /** @type {[number, number]} */ ([row - first, column])),
  };
}
