import { EngineError } from "../engine/engine.js";
import { Histories } from "../histories/histories.js";
import { element } from "../look/elements.js";
import { label } from "../look/words.js";
import { NumbersTable } from "./numbers_table.js";
import { Player } from "./player.js";
import { StagePanel } from "./stage_panel.js";
import { TransportBar } from "./transport.js";

/** @typedef {import("../engine/types.js").Landing} Landing */
/** @typedef {import("../engine/types.js").Units} Units */

/** One landing, or several side by side in step: pictures, one time, histories over each other. */
export class Replay {
  /** @param {string[]} names of the landings, for screen readers */
  constructor(names) {
    this.player = new Player();
    this.panels = names.map((name) => new StagePanel(name));
    this.bar = new TransportBar(this.player, names.length > 1 ? "both landings" : "the landing");
    this.histories = new Histories(this.player);
    this.stages = element("div", { class: "stages" }, ...this.panels.map(({ root }) => root));
    this.numbers = new NumbersTable();
    this.root = element("div", { class: "replay" }, this.stages, this.bar.root, this.histories.root, this.numbers.root);
    this.player.addEventListener("time", () => this.panels.forEach(({ view }) => view.at(this.player.time)));
    this.root.addEventListener("keydown", (event) => {
      if (event.key !== " " || !(event.target instanceof HTMLCanvasElement)) return;
      event.preventDefault();
      this.player.toggle();
    });
    for (const panel of this.panels) {
      panel.view.stage.controls.addEventListener("change", () => this.#turnOthers(panel));
      panel.root.addEventListener("view", () => {
        for (const other of this.panels) if (other !== panel) other.view.look(panel.view.view);
      });
    }
  }

  /** Cameras stand alike, each relative to its lander. @param {StagePanel} panel */
  #turnOthers(panel) {
    if (this.isTurning) return;
    this.isTurning = true;
    const { camera, controls } = panel.view.stage;
    for (const { view } of this.panels.filter((other) => other !== panel)) {
      view.stage.camera.position.copy(camera.position).sub(controls.target).add(view.stage.controls.target);
      view.stage.controls.update();
      view.stage.draw();
    }
    this.isTurning = false;
  }

  /**
   * Shows landings, at their end when they are the first.
   * @param {Landing[]} landings
   * @param {Units} units
   * @param {number[]} [places] which panels they are for
   */
  show(landings, units, places = [...landings.keys()]) {
    landings.forEach((landing, index) => this.panels[places[index]].show(landing, speedOf(landing, units)));
    this.player.setEnd(Math.max(...landings.map(({ end_time_s }) => end_time_s)), !this.hasShown);
    this.hasShown = true;
    this.bar.setEvents(landings.flatMap(({ events }) => events).sort((a, b) => a.time_s - b.time_s));
    const hasHistories = landings.every(({ history }) => history);
    if (hasHistories) this.histories.show(landings);
    this.histories.root.classList.toggle("stale", !hasHistories);
    this.numbers.show(landings);
    this.bar.root.classList.remove("stale");
    this.numbers.root.hidden = false;
  }

  /**
   * What comes of asking for landings; none, and the reason in place of a verdict, where the engine refuses.
   * @template T
   * @param {() => Promise<T>} ask
   */
  async landed(ask) {
    try {
      return await ask();
    } catch (error) {
      if (!(error instanceof EngineError)) throw error;
      this.refuse(error.message);
      return undefined;
    }
  }

  /** Says why there is no landing, in place of one that was shown for other numbers. @param {string} why */
  refuse(why) {
    this.player.pause();
    for (const panel of this.panels) panel.refuse(why);
    for (const { root } of [this.bar, this.histories]) root.classList.add("stale");
    this.numbers.root.hidden = true;
  }
}

/**
 * V_H of a landing, as its report has it.
 * @param {Landing} landing
 * @param {Units} units
 * @returns {import("./landing_view.js").Speed}
 */
export function speedOf(landing, units) {
  const scene = /** @type {Record<string, number>} */ (landing.report.scene ?? {});
  const fps = scene.horizontal_velocity_fps ?? scene.horizontal_velocity_mps / 0.3048;
  const words = units === "SI" ? `V_H ${label(fps * 0.3048, 5)} m/s` : `V_H ${label(fps, 5)} ft/s`;
  return { fps, words, units };
}
