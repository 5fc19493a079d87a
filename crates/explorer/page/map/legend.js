import { element } from "../look/elements.js";
import { subscripted } from "../look/words.js";

/** What the marks of a map mean, in the words of our pictures. @param {import("../engine/types.js").MapAnswer} map */
export function legendOf(map) {
  /** @type {HTMLElement[]} */
  const entries = [];
  const add = (/** @type {string} */ kind, /** @type {string | null | undefined} */ words) => {
    if (words) entries.push(element("span", {}, element("i", { class: `mark ${kind}` }), subscripted(words)));
  };
  const hasGaps = map.points.some(({ to }) => to === null);
  const hasLine = map.axes.length === 1 || map.grid !== null || map.triangles !== null;
  const line = map.axes.length > 1 ? "sections" : "line";
  for (const { class: kind, word } of map.kinds) {
    if (hasLine && map.points.some(({ to }) => to === kind)) add(`above ${kind}`, `${line}: V_H, above it: ${word}`);
  }
  if (map.grid) {
    add("lowest", `lowest V_H at each ${(map.axes[0].title.split(/ angle| [^ ]*,|,/)[0] || map.axes[0].name).toLowerCase()}`);
    if (map.bisector.length) add("bisector", map.words.bisector);
    if (map.jump_bars.length) add("jump", map.words.jump);
    if (map.jump_cells.length) add("torn", map.words.jump_cell);
  }
  if (map.words.missing) entries.push(element("span", { class: "missing" }, map.words.missing));
  if (hasGaps) add(map.triangles ? "white" : "gap", map.words.gap);
  const edges = new Set(map.edges.map(({ kind }) => kind));
  for (const kind of ["end", "jump", "bands"]) if (edges.has(/** @type {"end"} */ (kind))) add(`edge-${kind}`, map.words[kind === "jump" ? "edge_jump" : kind]);
  if (map.points.some(({ certainty }) => certainty === "disputed")) add("disputed", "disputed: the smallest change of the input decides");
  if (map.points.some(({ patchy_to }) => patchy_to !== null)) add("patchy", "patchy: stable landings among others");
  for (const kind of ["failure", "undecided"]) {
    if (map.points.some(({ to }) => to === kind)) add(kind, map.kinds.find((known) => known.class === kind)?.word ?? kind);
  }
  return entries;
}
