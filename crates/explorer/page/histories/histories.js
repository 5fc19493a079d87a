import { element } from "../look/elements.js";
import { curveColour, onTheme, pale } from "../look/theme.js";
import { energyContent } from "./energy_chart.js";
import { panels, times } from "./panels.js";
import { TimeChart } from "./time_chart.js";

/** @typedef {import("../engine/types.js").Landing} Landing */
/** A landing that others are compared with. @typedef {{ landing: Landing, name: string }} Kept */

/** Dashes of the landings beside the first, pixels. */
const DASHES = [[5, 4], [2, 3], [10, 3, 2, 3], [12, 6]];

/** The time histories of a landing, or of two over each other, with cursors tied to a player. */
export class Histories {
  /** @param {import("../landing/player.js").Player} player */
  constructor(player) {
    this.player = player;
    this.root = element("div", { class: "histories" });
    /** @type {TimeChart[]} */
    this.charts = [];
    /** @type {Kept[]} what lies under a landing */
    this.kept = [];
    player.addEventListener("time", () => this.charts.forEach((chart) => chart.at(player.time)));
    onTheme(() => this.landings && this.show(this.landings));
  }

  /** @param {Kept[]} kept landings that are drawn under the one that is shown */
  keep(kept) {
    this.kept = kept;
    if (this.landings) this.show(this.landings);
  }

  /** @param {Landing[]} landings one, or two to be compared */
  show(landings) {
    this.landings = landings;
    const contents = landings.length === 1 ? alone(landings[0], this.kept) : together(landings);
    while (this.charts.length < contents.length) {
      const chart = new TimeChart((time) => {
        this.player.pause();
        this.player.go(time);
      });
      chart.onSeen = () => this.#draw();
      this.charts.push(chart);
      this.root.append(chart.root);
    }
    for (const extra of this.charts.splice(contents.length)) extra.root.remove();
    contents.forEach((content, index) => this.charts[index].offer(content));
    this.#draw();
  }

  /** Draws charts that can be seen, one a frame, so that the picture above never waits for them. */
  #draw() {
    if (this.isDrawing) return;
    this.isDrawing = true;
    const step = () => {
      const next = this.charts.find((chart) => chart.isWaiting);
      if (!next) {
        this.isDrawing = false;
        return;
      }
      next.time = this.player.time;
      next.draw();
      requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }
}

/**
 * A landing of a chart: its curves have this word for a name, if any, and are drawn through without dashes.
 * @typedef {{ landing: Landing, word?: string, dash?: number[], isPale?: boolean }} Overlaid
 */

/** @param {Landing} landing @param {Kept[]} kept */
function alone(landing, kept) {
  const { history, energies, events } = landing;
  if (!history) return [];
  const others = kept.map(({ landing, name }, index) => ({ landing, word: name, dash: DASHES[index % DASHES.length], isPale: true }));
  const contents = overlaid([{ landing }, ...others]).map((content) => ({ ...content, events }));
  return energies ? [...contents, energyContent(energies, times(history.columns), events)] : contents;
}

/** @param {Landing[]} landings below a boundary, and above it */
const together = ([below, above]) => overlaid([{ landing: below, word: "below" }, { landing: above, word: "above", dash: DASHES[0] }]);

/**
 * Panels of landings over each other, over the times of all.
 * @param {Overlaid[]} all
 * @returns {import("./time_chart.js").Content[]}
 */
function overlaid(all) {
  const known = all.flatMap(({ landing: { history }, ...looks }) => {
    if (!history) return [];
    return [{ ...looks, own: times(history.columns), panels: panels(history.columns) }];
  });
  if (known.length === 0) return [];
  const at = known.reduce((/** @type {number[]} */ sum, { own }) => [...sum, ...own.filter((time) => !(time <= sum[sum.length - 1]))], []);
  return known[0].panels.flatMap(({ title, unit }) => {
    const curves = known.flatMap(({ own, panels, word, dash, isPale }) => {
      const same = panels.find((panel) => panel.title === title)?.curves ?? [];
      return same.map((curve, number) => ({
        name: word && (dash || same.length === 1) ? word : curve.name,
        values: valuesAt(at, own, curve.values),
        colour: isPale ? pale(curveColour(number)) : curveColour(number),
        dash,
      }));
    });
    // A lander without blocks has no block load.
    const isEmpty = curves.every(({ values }) => values.every((value) => !value));
    return isEmpty ? [] : [{ title, unit, times: at, curves, events: [] }];
  });
}

/**
 * Values at other times than their own, straight in between; none beyond the last.
 * @param {number[]} at @param {number[]} own @param {(number | null)[]} values
 */
function valuesAt(at, own, values) {
  let next = 0;
  return at.map((time) => {
    while (next < own.length - 1 && own[next] < time) next += 1;
    if (own[next] === time) return values[next];
    const [before, after] = [values[next - 1] ?? null, values[next]];
    if (own[next] < time || before === null || after === null) return null;
    return before + ((after - before) * (time - own[next - 1])) / (own[next] - own[next - 1]);
  });
}
