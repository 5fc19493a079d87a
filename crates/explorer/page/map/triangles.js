/** The surface of V_H as triangles, cut by levels: what contour map and surface are drawn from. */

/** @typedef {[slow: number, fast: number, speed: number]} Corner */
/** @typedef {[Corner, Corner, Corner]} Triangle */
/** @typedef {import("../engine/types.js").MapAnswer} MapAnswer */

/** Triangles of a map: its own, or four about the middle of every whole cell of its grid. @param {MapAnswer} map @returns {Triangle[]} */
export function trianglesOf(map) {
  if (map.triangles) return /** @type {Triangle[]} */ (map.triangles);
  if (!map.grid) return [];
  const [{ values: slow }, { values: fast }] = map.axes;
  const { speeds } = map.grid;
  const torn = new Set(map.jump_cells.map((cell) => cell.join()));
  /** @type {Triangle[]} */
  const triangles = [];
  for (let row = 0; row + 1 < slow.length; row += 1) {
    for (let column = 0; column + 1 < fast.length; column += 1) {
      if (torn.has([row, column].join())) continue;
      const corner = (/** @type {number} */ r, /** @type {number} */ c) =>
        /** @type {[number, number, number | null]} */ ([slow[row + r], fast[column + c], speeds[row + r][column + c]]);
      const ring = [corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0)];
      if (ring.some(([, , speed]) => speed === null)) continue;
      const whole = /** @type {Corner[]} */ (ring);
      const mean = (/** @type {0 | 1 | 2} */ axis) => whole.reduce((sum, corner) => sum + corner[axis], 0) / 4;
      /** @type {Corner} */
      const middle = [mean(0), mean(1), mean(2)];
      for (let i = 0; i < 4; i += 1) triangles.push([whole[i], whole[(i + 1) % 4], middle]);
    }
  }
  return triangles;
}

/** Bands of colour from below. @param {MapAnswer["levels"]} levels */
export function bandsOf(levels) {
  return levels.map(({ speed, colour }, index) => ({
    low: index === 0 ? -Infinity : /** @type {number} */ (levels[index - 1].speed),
    high: speed ?? Infinity,
    colour,
  }));
}

/** Polygons that cover where the surface lies within a band. @param {Triangle[]} triangles @param {number} low @param {number} high */
export function band(triangles, low, high) {
  const polygons = [];
  for (const triangle of triangles) {
    const [a, b, c] = [triangle[0][2], triangle[1][2], triangle[2][2]];
    if (Math.max(a, b, c) < low || Math.min(a, b, c) > high) continue;
    const polygon = clip(clip(triangle, low, 1), high, -1);
    if (polygon.length > 2) polygons.push(polygon);
  }
  return polygons;
}

/** Pieces of the lines at a level. @param {Triangle[]} triangles @param {number} level @returns {[Corner, Corner][]} */
export function pieces(triangles, level) {
  /** @type {[Corner, Corner][]} */
  const found = [];
  for (const triangle of triangles) {
    const ends = [];
    for (let i = 0; i < 3; i += 1) {
      const [from, to] = [triangle[i], triangle[(i + 1) % 3]];
      if (from[2] < level === to[2] < level) continue;
      // From the lower corner always, so that triangles side by side agree to the bit.
      ends.push(from[2] < to[2] ? crossing(from, to, level) : crossing(to, from, level));
    }
    if (ends.length === 2) found.push([ends[0], ends[1]]);
  }
  return found;
}

/** Pieces joined to lines. @param {[Corner, Corner][]} unjoined */
export function joined(unjoined) {
  const key = (/** @type {Corner} */ [slow, fast]) => `${slow.toPrecision(10)} ${fast.toPrecision(10)}`;
  /** @type {Map<string, Set<[Corner, Corner]>>} */
  const at = new Map();
  for (const piece of unjoined) {
    for (const end of piece) {
      const known = at.get(key(end)) ?? new Set();
      at.set(key(end), known.add(piece));
    }
  }
  const left = new Set(unjoined);
  const lines = [];
  for (const piece of left) {
    left.delete(piece);
    const line = [...piece];
    for (const isFront of [false, true]) {
      for (;;) {
        const end = isFront ? line[0] : line[line.length - 1];
        const next = [...(at.get(key(end)) ?? [])].find((other) => left.has(other));
        if (!next) break;
        left.delete(next);
        const far = key(next[0]) === key(end) ? next[1] : next[0];
        if (isFront) line.unshift(far);
        else line.push(far);
      }
    }
    lines.push(line);
  }
  return lines;
}

/** @param {Corner} a @param {Corner} b @param {number} level @returns {Corner} */
function crossing(a, b, level) {
  const part = (level - a[2]) / (b[2] - a[2]);
  return [a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1]), level];
}

/** The part of a polygon above a level, or below it for a side of −1. @param {Corner[]} polygon @param {number} level @param {number} side */
function clip(polygon, level, side) {
  if (!Number.isFinite(level)) return polygon;
  const inside = (/** @type {Corner} */ corner) => side * (corner[2] - level) >= 0;
  /** @type {Corner[]} */
  const kept = [];
  for (const [index, corner] of polygon.entries()) {
    const next = polygon[(index + 1) % polygon.length];
    if (inside(corner)) kept.push(corner);
    if (inside(corner) !== inside(next)) kept.push(crossing(corner, next, level));
  }
  return kept;
}
