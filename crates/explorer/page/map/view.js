/** Which way the axes of a map run: those of cross-slope and roll as the report has them, others upward and to the right. */

/** @typedef {import("../engine/types.js").MapAnswer} MapAnswer */

/** @param {MapAnswer} map */
export function viewOf(map) {
  const [slow, fast] = map.axes;
  const isReport = slow.name === "cross_slope_deg" && fast?.name === "roll_deg";
  const ends = (/** @type {number[]} */ values, /** @type {number[]} */ more) => {
    const all = [...values, ...more];
    const [low, high] = [Math.min(...all), Math.max(...all)];
    return { low, high, span: high - low || 1 };
  };
  const corners = map.triangles?.flat() ?? [];
  const slowEnds = ends(slow.values, corners.map((corner) => corner[0]));
  const fastEnds = ends(fast?.values ?? [0, 1], corners.map((corner) => corner[1]));
  const turn = (/** @type {number} */ share) => (isReport ? 1 - share : share);
  return {
    slowEnds,
    fastEnds,
    /** Whether the fast axis runs to the left, and the slow one down. */
    isTurned: isReport,
    /** Share of the height and of the width of the picture. @param {number} slow @param {number} fast */
    at: (slow, fast) => ({ up: turn((slow - slowEnds.low) / slowEnds.span), across: turn((fast - fastEnds.low) / fastEnds.span) }),
    /** The place of such shares. @param {number} up @param {number} across */
    placeOf: (up, across) => ({ slow: slowEnds.low + turn(up) * slowEnds.span, fast: fastEnds.low + turn(across) * fastEnds.span }),
  };
}

/** The computed point nearest to a place. @param {MapAnswer} map @param {number} slow @param {number} fast */
export function nearestPoint(map, slow, fast) {
  const { slowEnds, fastEnds } = viewOf(map);
  let best;
  let least = Infinity;
  for (const point of map.points) {
    const across = point.place.length > 1 ? (point.place[1] - fast) / fastEnds.span : 0;
    const distance = ((point.place[0] - slow) / slowEnds.span) ** 2 + across ** 2;
    if (distance < least) [best, least] = [point, distance];
  }
  return best;
}
