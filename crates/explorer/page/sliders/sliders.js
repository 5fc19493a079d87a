import * as engine from "../engine/engine.js";
import { button, element } from "../look/elements.js";
import { Newest } from "../engine/newest.js";
import { NumberSlider } from "./slider.js";

/** @typedef {import("../engine/types.js").Parameter} Parameter */

/** Groups in the order of the page. @type {[string, string][]} */
const GROUPS = [
  ["touchdown", "Touchdown"], ["attitude", "Attitude"], ["ground", "Ground"], ["soil", "Soil"], ["thrust", "Thrust"], ["body", "Body"],
  ["inertia", "Inertia"], ["linkage", "Linkage"], ["strut", "Strut"],
  ["primary", "Primary strut"], ["secondary", "Secondary struts"], ["footpad", "Footpad"], ["block", "Body block"],
  ["azimuth", "Azimuths of the legs"], ["footing", "Ground under each leg"], ["solver", "Solver"],
];
const OPEN = new Set(["touchdown", "attitude", "ground"]);

/** Every number of the input as a slider, in groups that fold, with a search. */
export class Sliders {
  /** @param {import("../present/present.js").Present} present */
  constructor(present) {
    this.present = present;
    this.search = element("input", { type: "search", placeholder: "Search numbers …", "aria-label": "Search numbers" });
    const back = button("All as in the input", "Give back all numbers of the input");
    back.addEventListener("click", () => present.replace({ source: present.source, values: {} }));
    this.groups = element("div", { class: "groups" });
    this.trouble = element("p", { class: "complaint", role: "alert" });
    this.root = element("div", { class: "sliders" }, element("div", { class: "search" }, this.search, back), this.trouble, this.groups);
    /** @type {Map<string, NumberSlider>} */
    this.sliders = new Map();
    /** @type {Parameter[]} */
    this.parameters = [];
    this.newest = new Newest();
    /** @type {import("../engine/types.js").Complaint | null} */
    this.complaint = null;
    /** Names of the numbers that have sliders. */
    this.built = "";
    this.isRefused = false;
    /** @type {string | undefined} whose numbers they are */
    this.source = undefined;
    this.search.addEventListener("input", () => this.#filter());
    present.addEventListener("values", () => present.isMoving || this.refresh());
    present.addEventListener("units", () => this.#show());
  }

  /** Asks for the numbers as they are. */
  refresh() {
    return this.newest.run(async () => {
      const { touchdown } = this.present;
      this.isRefused = false;
      try {
        this.parameters = await engine.parameters(touchdown);
      } catch (error) {
        if (!(error instanceof engine.EngineError)) throw error;
        // The landing tells what is wrong. The numbers are those of the source, so that what is wrong can be changed.
        this.isRefused = true;
        if (this.source !== touchdown.source) this.parameters = await engine.parameters({ ...touchdown, values: {} });
      }
      this.source = touchdown.source;
      const names = this.parameters.map(({ name }) => name).join();
      const isOther = names !== this.built;
      if (isOther) this.#build();
      this.built = names;
      this.#show();
      // Sliders made afresh have not been told.
      if (isOther) this.complain(this.complaint);
    });
  }

  #build() {
    this.sliders.clear();
    const known = new Map(GROUPS);
    for (const { group } of this.parameters) if (!known.has(group)) known.set(group, group);
    const folds = [...known].flatMap(([group, title]) => {
      const of = this.parameters.filter((parameter) => parameter.group === group);
      return of.length ? [this.#fold(group, title, of)] : [];
    });
    this.groups.replaceChildren(...folds);
    this.#filter();
  }

  /** @param {string} group @param {string} title @param {Parameter[]} of */
  #fold(group, title, of) {
    const fold = element("details", { class: "fold" }, element("summary", {}, title));
    fold.open = OPEN.has(group);
    fold.append(...of.filter(({ leg }) => leg === null).map((parameter) => this.#slider(parameter)));
    const legs = [...new Set(of.flatMap(({ leg }) => (leg === null ? [] : [leg])))];
    for (const number of legs) {
      const inner = element("details", { class: "fold leg" }, element("summary", {}, `Leg ${number}`));
      const own = of.filter(({ leg }) => leg === number);
      // Those of single legs are many: they are made when they are wanted.
      const fill = () => {
        if (inner.childElementCount > 1) return;
        inner.append(...own.map((parameter) => this.#slider(parameter)));
        this.#show();
      };
      inner.addEventListener("toggle", () => inner.open && fill());
      inner.addEventListener("fill", fill);
      fold.append(inner);
    }
    return fold;
  }

  /** @param {Parameter} parameter */
  #slider(parameter) {
    const slider = new NumberSlider(parameter, (name, value, isMoving) => this.#change(parameter, name, value, isMoving));
    this.sliders.set(parameter.name, slider);
    return slider.root;
  }

  /**
   * @param {Parameter} parameter
   * @param {string} name as it is shown
   * @param {number | string | undefined} value
   * @param {boolean} isMoving
   */
  #change(parameter, name, value, isMoving) {
    // One spelling of a number at a time.
    for (const other of [parameter.name, parameter.si?.name]) if (other && other !== name) delete this.present.values[other];
    if (value === undefined) delete this.present.values[name];
    this.present.set(name, value, isMoving);
  }

  #show() {
    for (const parameter of this.parameters) {
      const { values, units } = this.present;
      this.sliders.get(parameter.name)?.show(parameter, units, values, this.isRefused);
    }
  }

  #filter() {
    const words = this.search.value.toLowerCase().split(/\s+/).filter(Boolean);
    for (const fold of this.groups.querySelectorAll("details.leg")) if (words.length) fold.dispatchEvent(new Event("fill"));
    for (const [name, slider] of this.sliders) {
      const text = `${slider.parameter.title} ${name}`.toLowerCase();
      slider.root.hidden = !words.every((word) => text.includes(word));
    }
    for (const fold of /** @type {NodeListOf<HTMLDetailsElement>} */ (this.groups.querySelectorAll("details"))) {
      const some = fold.querySelector(".number:not([hidden])") !== null || (!words.length && fold.classList.contains("leg"));
      fold.hidden = words.length > 0 && !some;
      if (words.length) fold.open = some;
    }
  }

  /** Shows a complaint at the number that it is about, or takes all away. @param {import("../engine/types.js").Complaint | null} complaint */
  complain(complaint) {
    this.complaint = complaint;
    for (const slider of this.sliders.values()) slider.complain("");
    this.trouble.textContent = "";
    if (!complaint) return;
    const { key } = complaint;
    const bare = (/** @type {string} */ name) => name.replace(/^(scene|vehicle)\./, "");
    const blamed = [...this.sliders.values()].find(({ parameter }) =>
      key !== null && [parameter.name, parameter.si?.name].some((name) => name && (name === key || bare(name) === bare(key))));
    if (blamed) blamed.complain(complaint.message);
    if (!blamed || blamed.root.offsetParent === null) this.trouble.textContent = complaint.message;
  }
}
