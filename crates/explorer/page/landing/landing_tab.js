import * as engine from "../engine/engine.js";
import { Newest } from "../engine/newest.js";
import { Histories } from "../histories/histories.js";
import { element } from "../look/elements.js";
import { label } from "../look/words.js";
import { Player } from "./player.js";
import { StagePanel } from "./stage_panel.js";
import { TransportBar } from "./transport.js";

/** Instants of a landing while a slider moves. */
const COARSE = 240;

/** The present landing: its picture, its time, its histories. */
export class LandingTab {
  /** @param {import("../present/present.js").Present} present @param {import("../engine/types.js").Source[]} sources */
  constructor(present, sources) {
    this.present = present;
    this.sources = sources;
    this.player = new Player();
    this.stage = new StagePanel("The landing");
    this.bar = new TransportBar(this.player, "the landing");
    this.histories = new Histories(this.player);
    this.newest = new Newest();
    this.show = element("div", { class: "show" }, this.stage.root, this.bar.root, this.histories.root);
    this.aside = element("aside", { class: "aside", "aria-label": "Numbers" });
    this.root = element("section", { class: "landing-tab" }, this.aside, this.show);
    this.player.addEventListener("time", () => this.stage.view.at(this.player.time));
    present.addEventListener("values", () => this.refresh());
    present.addEventListener("units", () => this.refresh());
    this.root.addEventListener("keydown", (event) => {
      if (event.key !== " " || !(event.target instanceof HTMLCanvasElement)) return;
      event.preventDefault();
      this.player.toggle();
    });
  }

  /** Lands afresh. */
  refresh() {
    return this.newest.run(async () => {
      const { touchdown, units, isMoving } = this.present;
      const interval_s = isMoving && this.landing ? Math.max(this.landing.end_time_s / COARSE, 0.01) : 0.01;
      const landing = await engine.landing({ touchdown, units, interval_s });
      this.landing = landing;
      const speed = speedOf(landing, units);
      this.stage.show(landing, speed);
      this.player.setEnd(landing.end_time_s, !this.hasShown);
      this.hasShown = true;
      this.bar.setEvents(landing.events);
      this.histories.show([landing]);
    });
  }
}

/**
 * V_H of a landing, as its report has it.
 * @param {import("../engine/types.js").Landing} landing
 * @param {"US" | "SI"} units
 * @returns {import("./landing_view.js").Speed}
 */
export function speedOf(landing, units) {
  const scene = /** @type {Record<string, number>} */ (landing.report.scene ?? {});
  const fps = scene.horizontal_velocity_fps ?? scene.horizontal_velocity_mps / 0.3048;
  const words = units === "SI" ? `V_H ${label(fps * 0.3048, 5)} m/s` : `V_H ${label(fps, 5)} ft/s`;
  return { fps, words, units };
}
