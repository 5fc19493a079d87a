import { BoundaryChart } from "./boundary_chart.js";
import { element } from "../look/elements.js";
import { label } from "../look/words.js";
import { trianglesOf } from "./triangles.js";
import { viewOf } from "./view.js";

/** @typedef {import("../engine/types.js").MapAnswer} MapAnswer */
/** @typedef {import("../engine/types.js").MapPoint} MapPoint */
/** @typedef {import("./boundary_chart.js").Place} Place */

/** Sections through a map along either axis, through the point that is chosen. */
export class Sections {
  /** @param {(point: MapPoint | undefined) => void} onHover @param {(point: MapPoint) => void} onChoose */
  constructor(onHover, onChoose) {
    this.charts = [new BoundaryChart(onHover, onChoose), new BoundaryChart(onHover, onChoose)];
    this.root = element("div", { class: "sections" }, ...this.charts.map(({ root }) => root));
  }

  /** @param {MapAnswer} map @param {MapPoint} point */
  show(map, point) {
    // Along the fast axis first: across the map.
    for (const [index, along] of [1, 0].entries()) {
      const still = 1 - along;
      const at = point.place[still];
      const { title, unit } = map.axes[still];
      this.charts[index].set({
        title: map.axes[along].title,
        note: `at ${title.replace(/,.*$/, "")} = ${label(at)}${unit ? ` ${unit}` : ""}`,
        unit: map.speed_unit,
        places: map.grid ? onGrid(map, along, at) : throughTriangles(map, along, at),
        isTurned: along === 1 && viewOf(map).isTurned,
        chosen: point.place[along],
      });
    }
  }
}

/** @param {MapAnswer} map @param {number} along @param {number} at @returns {Place[]} */
function onGrid(map, along, at) {
  const points = map.points.filter(({ place }) => place[1 - along] === at).sort((a, b) => a.place[along] - b.place[along]);
  return points.map((point, index) => {
    const next = points[index + 1];
    const rise = next && next.speed !== null && point.speed !== null ? Math.abs(next.speed - point.speed) : 0;
    return { x: point.place[along], point, breaks: map.jump !== null && rise > map.jump };
  });
}

/** Of a refined map: where a plane cuts its triangles. @param {MapAnswer} map @param {number} along @param {number} at @returns {Place[]} */
function throughTriangles(map, along, at) {
  const still = 1 - along;
  /** @type {{ from: [number, number], to: [number, number] }[]} */
  const cuts = [];
  for (const triangle of trianglesOf(map)) {
    /** @type {[number, number][]} */
    const ends = [];
    for (let i = 0; i < 3; i += 1) {
      const [a, b] = [triangle[i], triangle[(i + 1) % 3]];
      if (a[still] <= at === b[still] <= at) continue;
      const part = (at - a[still]) / (b[still] - a[still]);
      ends.push([a[along] + part * (b[along] - a[along]), a[2] + part * (b[2] - a[2])]);
    }
    if (ends.length !== 2) continue;
    const [from, to] = ends[0][0] <= ends[1][0] ? ends : [ends[1], ends[0]];
    cuts.push({ from, to });
  }
  cuts.sort((a, b) => a.from[0] - b.from[0]);
  const kind = map.points.find(({ speed }) => speed !== null)?.to ?? null;
  return cuts.flatMap(({ from, to }, index) => {
    const next = cuts[index + 1];
    const place = (/** @type {[number, number]} */ [x, speed], /** @type {boolean} */ breaks) => {
      const coordinates = along === 0 ? [x, at] : [at, x];
      return { x, breaks, point: { place: coordinates, speed, low: null, high: null, to: kind, certainty: null, disputed: null, patchy_to: null } };
    };
    const isLast = !next || Math.abs(next.from[0] - to[0]) + Math.abs(next.from[1] - to[1]) > 1e-6;
    return isLast ? [place(from, false), place(to, true)] : [place(from, false)];
  });
}
