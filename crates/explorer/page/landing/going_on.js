import { button } from "../look/elements.js";

const STOP = "solver.stop";

/** The button by which a landing goes on beyond its verdict, up to the time limit. */
export class GoingOn {
  /** @param {import("../present/present.js").Present} present @param {import("./player.js").Player} player */
  constructor(present, player) {
    this.present = present;
    this.player = player;
    this.root = button("Go on", "Go on beyond the verdict, up to the time limit");
    this.root.setAttribute("aria-pressed", "false");
    /** Whether what comes next is to be played from the verdict on. */
    this.isAsked = false;
    this.root.addEventListener("click", () => {
      const isOn = this.root.getAttribute("aria-pressed") === "true";
      this.isAsked = !isOn;
      present.set(STOP, isOn ? "rest" : "time");
    });
  }

  /** @param {import("../engine/types.js").Landing} landing */
  show({ events, verdict_time_s }) {
    this.root.setAttribute("aria-pressed", String(events.some(({ kind }) => kind === "end")));
    if (!this.isAsked) return;
    this.isAsked = false;
    this.player.go(verdict_time_s);
    this.player.play();
  }
}
