import { colours, curveColour } from "../look/theme.js";

/** @typedef {import("../engine/types.js").Energies} Energies */

/**
 * The energies of a landing stacked upon each other: together they reach what the landing had at contact and what gravity
 * released since.
 * @param {Energies} energies
 * @param {number[]} times
 * @param {{ time_s: number, kind: string }[]} events
 * @returns {import("./time_chart.js").Content}
 */
export function energyContent(energies, times, events) {
  let below = times.map(() => 0);
  const floor = { name: "", values: below, colour: "transparent", width: 0 };
  const layers = energies.parts.map((part, index) => {
    below = below.map((sum, instant) => sum + part.values[instant]);
    return { name: part.title, values: below, readings: part.values, colour: curveColour(index), width: 1 };
  });
  const total = { name: "at contact and released since", values: energies.total, colour: colours().text, dash: [5, 4], width: 1.6 };
  const bands = layers.map((layer, index) => {
    /** @type {[number, number]} */
    const series = [index + 2, index + 1];
    return { series, fill: `${layer.colour}66` };
  });
  return { title: "Energy, stacked", unit: energies.unit, times, curves: [floor, ...layers, total], bands, events };
}
