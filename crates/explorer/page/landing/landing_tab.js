import * as engine from "../engine/engine.js";
import { Newest } from "../engine/newest.js";
import { button, element } from "../look/elements.js";
import { subscripted } from "../look/words.js";
import { OutcomeStrip } from "../strip/strip.js";
import { Sliders } from "../sliders/sliders.js";
import { GoingOn } from "./going_on.js";
import { Kept } from "./kept.js";
import { Replay, speedOf } from "./replay.js";
import { STILL } from "./sharpness.js";

/** Instants of a landing while a slider moves. */
const COARSE = 60;

/** The present landing: its numbers, its picture and histories, and how its neighbours in V_H end. */
export class LandingTab {
  /** @param {import("../present/present.js").Present} present @param {import("../engine/types.js").Source[]} sources */
  constructor(present, sources) {
    this.present = present;
    this.replay = new Replay(["The landing"]);
    this.goingOn = new GoingOn(present, this.replay.player);
    this.kept = new Kept(present);
    this.replay.bar.root.append(this.goingOn.root, this.kept.button);
    this.replay.histories.root.before(this.kept.root);
    this.kept.addEventListener("changed", () => this.replay.histories.keep(this.kept.named()));
    this.strip = new OutcomeStrip(present, sources);
    this.sliders = new Sliders(present);
    this.newest = new Newest();
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    this.rest = undefined;
    this.replay.bar.root.after(this.strip.root);
    const hint = element("p", { class: "hint" });
    hint.append(subscripted("Drag anything: the picture to turn it, the handle below for V_H, any slider for its number, a curve for its time."));
    this.replay.bar.root.before(hint);
    const show = element("div", { class: "show" }, this.replay.root);
    const sheet = button("Numbers");
    sheet.classList.add("sheet");
    const aside = element("aside", { class: "aside", "aria-label": "Numbers" }, sheet, this.sliders.root);
    sheet.addEventListener("click", () => {
      const isOpen = aside.classList.toggle("open");
      sheet.setAttribute("aria-expanded", String(isOpen));
      // In a narrow window the sheet covers what is below the verdict and the picture.
      if (isOpen) this.replay.panels[0].root.scrollIntoView();
    });
    this.root = element("section", { class: "landing-tab" }, show, aside);
    present.addEventListener("values", () => this.refresh());
    present.addEventListener("units", () => this.refresh());
  }

  /**
   * Lands afresh. While a slider moves only what the picture takes is asked for, and all of it once it rests.
   * @param {boolean} [isMoving]
   */
  refresh(isMoving = this.present.isMoving && this.landing !== undefined) {
    clearTimeout(this.rest);
    if (isMoving) this.rest = setTimeout(() => this.refresh(false), STILL);
    return this.newest.run(async () => {
      const { touchdown, units } = this.present;
      const interval_s = isMoving && this.landing ? Math.max(this.landing.end_time_s / COARSE, 0.01) : 0.01;
      try {
        const landing = await engine.landing({ touchdown, units, interval_s, history: !isMoving });
        this.landing = landing;
        if (!isMoving) this.replay.histories.keep(this.kept.named());
        this.replay.show([landing], units);
        this.goingOn.show(landing);
        this.strip.follow(speedOf(landing, units).fps);
        this.sliders.complain(null);
        this.root.dispatchEvent(new Event("landed"));
      } catch (error) {
        if (!(error instanceof engine.EngineError)) throw error;
        this.replay.refuse(error.complaint.message);
        this.strip.refuse();
        this.sliders.complain(error.complaint);
      }
    });
  }
}
