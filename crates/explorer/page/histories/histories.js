import { element } from "../look/elements.js";
import { curveColour, onTheme } from "../look/theme.js";
import { energyContent } from "./energy_chart.js";
import { panels, times } from "./panels.js";
import { TimeChart } from "./time_chart.js";

/** @typedef {import("../engine/types.js").Landing} Landing */

/** The time histories of a landing, or of two over each other, with cursors tied to a player. */
export class Histories {
  /** @param {import("../landing/player.js").Player} player */
  constructor(player) {
    this.player = player;
    this.root = element("div", { class: "histories" });
    /** @type {TimeChart[]} */
    this.charts = [];
    player.addEventListener("time", () => this.charts.forEach((chart) => chart.at(player.time)));
    onTheme(() => this.landings && this.show(this.landings));
  }

  /** @param {Landing[]} landings one, or two to be compared */
  show(landings) {
    this.landings = landings;
    const contents = landings.length === 1 ? alone(landings[0]) : together(landings);
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

/** @param {Landing} landing */
function alone({ history, energies, events }) {
  if (!history) return [];
  const at = times(history.columns);
  const contents = panels(history.columns).map((panel) => ({ ...panel, times: at, events }));
  return energies ? [...contents, energyContent(energies, at, events)] : contents;
}

/**
 * Panels of two landings over each other, over the times of both.
 * @param {Landing[]} landings
 */
function together(landings) {
  const known = landings.flatMap((landing, number) => {
    if (!landing.history) return [];
    const at = times(landing.history.columns);
    return [{ at, all: panels(landing.history.columns), dash: number === 0 ? undefined : [5, 4], word: number === 0 ? "below" : "above" }];
  });
  if (known.length === 0) return [];
  const at = known.reduce((longest, { at }) => (at.length > longest.length ? at : longest), known[0].at);
  return known[0].all.map((panel, index) => {
    const curves = known.flatMap(({ all, dash, word }) =>
      all[index].curves.map((curve, number) => ({
        name: all[index].curves.length > 1 && !dash ? curve.name : word,
        values: at.map((_, instant) => curve.values[instant] ?? null),
        colour: curveColour(number),
        dash,
      })),
    );
    return { title: panel.title, unit: panel.unit, times: at, curves, events: [] };
  });
}
