/** Which panels the histories have, and which curves each of them: those of `touchdown plot`, and more. */

/** @typedef {import("../engine/types.js").Column} Column */
/** @typedef {{ title: string, unit: string, curves: { name: string, values: number[] }[] }} Panel */

/** Title, and the name and column of every curve; `#` stands for the number of a leg. The unit is that of the columns. */
/** @type {[string, [string, string][]][]} */
const PANELS = [
  ["Stability angle σ", [["σ", "sigma"]]],
  ["Clearance", [["least", "clearance"]]],
  ["Velocity", [["across", "x_rate"], ["up the slope", "y_rate"], ["down", "z_rate"]]],
  ["Attitude", [["pitch Ψ", "pitch"], ["yaw Φ", "yaw"], ["roll Ξ", "roll"]]],
  ["Strut force", [["leg #", "strut_force_#"]]],
  ["Strut stroke", [["leg #", "stroke_#"]]],
  ["Secondary struts' load", [["leg # a", "strut_force_a_#"], ["leg # b", "strut_force_b_#"]]],
  ["Secondary struts' stroke", [["leg # a", "stroke_a_#"], ["leg # b", "stroke_b_#"]]],
  ["Footpad load", [["leg #", "pad_normal_#"]]],
  ["Block load", [["leg #", "block_normal_#"]]],
];
const UNIT = /_(ft|in|m|fps|mps|deg|dps|lb|n|ftlb|j|s)$/;

/** @param {Column[]} columns @returns {Panel[]} */
export function panels(columns) {
  const byName = new Map(columns.map((column) => [column.name.replace(UNIT, ""), column]));
  return PANELS.flatMap(([title, curves]) => {
    const found = curves.flatMap(([name, pattern]) => curvesOf(byName, name, pattern));
    if (found.length === 0) return [];
    return [{ title, unit: found[0].unit, curves: found }];
  });
}

/** @param {Map<string, Column>} byName @param {string} name @param {string} pattern */
function curvesOf(byName, name, pattern) {
  const numbers = pattern.includes("#") ? [1, 2, 3, 4, 5, 6, 7, 8] : [0];
  return numbers.flatMap((number) => {
    const column = byName.get(pattern.replace("#", String(number)));
    return column ? [{ name: name.replace("#", String(number)), values: column.values, unit: column.unit }] : [];
  });
}

/** Times of a history, s. @param {Column[]} columns */
export const times = (columns) => columns.find((column) => column.name === "t_s")?.values ?? [];
