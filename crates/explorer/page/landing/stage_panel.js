import { button, element } from "../look/elements.js";
import { classColour, onTheme } from "../look/theme.js";
import { fixed, label, subscripted } from "../look/words.js";
import { LandingView } from "./landing_view.js";

/** @typedef {import("../engine/types.js").Landing} Landing */
/** @typedef {import("./stage.js").View} View */

/** @type {[View, string, string][]} */
const VIEWS = [
  ["corner", "Corner", "View from a corner"],
  ["uphill", "Uphill", "View from uphill"],
  ["downhill", "Downhill", "View from downhill"],
  ["side", "Side", "View from the side"],
  ["top", "Top", "View from above"],
];

/** The picture of a landing with its outcome, buttons of the views and what its marks mean. */
export class StagePanel {
  /** @param {string} name for screen readers */
  constructor(name) {
    this.canvas = element("canvas", { tabindex: 0, role: "img", "aria-label": `${name}, in three dimensions` });
    this.outcome = element("div", { class: "outcome", role: "status", "aria-live": "polite" });
    this.legend = element("div", { class: "stage-legend" });
    this.warning = element("p", { class: "warning" });
    const picture = element("div", { class: "stage" }, this.canvas);
    this.root = element("div", { class: "stage-panel" }, element("div", { class: "stage-and-words" }, this.outcome, picture, this.#buttons(), this.legend, this.warning));
    this.view = new LandingView(this.canvas);
    this.canvas.addEventListener("keydown", (event) => this.#turn(event));
    onTheme(() => this.landing && this.#write(this.landing));
  }

  #buttons() {
    const views = element("div", { class: "views", role: "group", "aria-label": "Views" });
    this.viewButtons = VIEWS.map(([view, text, title]) => {
      const made = button(text, title);
      made.addEventListener("click", () => this.look(view));
      made.dataset.view = view;
      views.append(made);
      return made;
    });
    const follow = toggle("Follow", "Camera follows the lander", true, (is) => {
      this.view.isFollowing = is;
    });
    const forces = toggle("Forces", "Arrows of forces", true, (is) => {
      this.view.hasForces = is;
      this.view.at(this.view.time);
      this.#writeLegend();
    });
    views.append(follow, forces);
    return views;
  }

  /** @param {View} view */
  look(view) {
    this.view.look(view);
    this.root.dispatchEvent(new Event("view"));
  }

  /** Turns the camera by the arrow keys. @param {KeyboardEvent} event */
  #turn(event) {
    const turns = /** @type {Record<string, [number, number, number]>} */ ({
      ArrowLeft: [-0.12, 0, 1], ArrowRight: [0.12, 0, 1], ArrowUp: [0, -0.08, 1], ArrowDown: [0, 0.08, 1],
      "+": [0, 0, 0.9], "=": [0, 0, 0.9], "-": [0, 0, 1.1],
    });
    const turn = turns[event.key];
    if (!turn) return;
    event.preventDefault();
    const { camera, controls } = this.view.stage;
    const arm = camera.position.clone().sub(controls.target);
    const [radius, polar, azimuth] = [arm.length() * turn[2], Math.acos(arm.y / arm.length()) + turn[1], Math.atan2(arm.x, arm.z) + turn[0]];
    const height = Math.min(Math.max(polar, 0.02), 3.1);
    arm.set(Math.sin(height) * Math.sin(azimuth), Math.cos(height), Math.sin(height) * Math.cos(azimuth)).multiplyScalar(radius);
    camera.position.copy(controls.target).add(arm);
    controls.update();
    this.view.stage.draw();
  }

  /** Takes the verdict away and says why there is none. @param {string} why */
  refuse(why) {
    this.landing = undefined;
    this.root.classList.add("stale");
    this.outcome.replaceChildren(element("p", { class: "word" }, "no landing"), element("p", { class: "why" }, why));
    this.outcome.dataset.class = "none";
    this.outcome.dataset.outcome = "none";
    this.warning.textContent = "";
  }

  /** @param {Landing} landing @param {import("./landing_view.js").Speed} speed */
  show(landing, speed) {
    this.landing = landing;
    this.root.classList.remove("stale");
    this.view.show(landing, speed);
    this.#write(landing);
  }

  /** @param {Landing} landing */
  #write(landing) {
    const dot = element("span", { class: "dot" });
    dot.style.background = classColour(landing.class);
    const word = element("strong", {}, landing.word);
    word.style.color = classColour(landing.class);
    const least = landing.report.result.min_stability_angle_deg;
    const goesOn = landing.end_time_s > landing.verdict_time_s ? ` · shown to ${fixed(landing.end_time_s, 3)} s` : "";
    const at = `${landing.outcome} at ${fixed(landing.verdict_time_s, 3)} s${goesOn}`;
    const sigma = typeof least === "number" ? ` · least stability angle ${fixed(least, 3)} deg` : "";
    const why = element("p", {}, landing.failure ?? landing.why);
    this.outcome.replaceChildren(element("p", { class: "word" }, dot, word), element("p", { class: "detail" }, at + sigma), why);
    this.warning.textContent = landing.warning ?? "";
    this.outcome.dataset.class = landing.class;
    this.outcome.dataset.outcome = landing.outcome;
    this.#writeLegend();
  }

  #writeLegend() {
    const isSi = this.view.speed?.units === "SI";
    const scale = label(this.view.forceScale);
    const force = this.view.hasForces && this.view.forceScale ? [`arrows: 1 ${isSi ? `m is ${scale} N` : `ft is ${scale} lb`}`] : [];
    const grid = isSi ? "grid: 0.2 m, bold 1 m" : "grid: 1 ft, bold 5 ft";
    const parts = [
      ["polygon", "polygon of the feet"], ["critical", "critical edge"], ["leaning", "from it to the CG"], ["path", "path of the CG, and plumb line"],
      ["ring", "ground below extended footpads"], ["force", "forces on footpads"], ["block", "on blocks"],
    ];
    const entries = parts
      .filter(([kind]) => this.view.hasForces || (kind !== "force" && kind !== "block"))
      .map(([kind, text]) => element("span", {}, element("i", { class: `key ${kind}` }), subscripted(text)));
    this.legend.replaceChildren(...entries, ...[...force, "struts redden with their stroke, pads and blocks as they crush", grid].map((text) => element("span", {}, text)));
  }
}

/** @param {string} text @param {string} title @param {boolean} is @param {(is: boolean) => void} change */
function toggle(text, title, is, change) {
  const made = button(text, title);
  made.setAttribute("aria-pressed", String(is));
  made.addEventListener("click", () => {
    const now = made.getAttribute("aria-pressed") !== "true";
    made.setAttribute("aria-pressed", String(now));
    change(now);
  });
  return made;
}
