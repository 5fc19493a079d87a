import * as engine from "../engine/engine.js";
import { button, element } from "../look/elements.js";
import { withUnit } from "../look/words.js";
import { save } from "../take/save.js";
import { ComputedMap } from "./computed_map.js";

/** @typedef {import("../engine/types.js").Parameter} Parameter */

/** Points along each side, and those offered first. */
const SIDES = [5, 9, 17, 33];
const SIDE = 9;
/** Axes that are offered first: up and across. */
const USUAL = ["cross_slope_deg", "roll_deg"];

/** What a new map is to be: two numbers of the present touchdown with their ranges, and how many points; it starts and stops. */
export class MapForm extends EventTarget {
  /** @param {import("../present/present.js").Present} present @param {import("../engine/types.js").Source[]} sources */
  constructor(present, sources) {
    super();
    this.present = present;
    this.sources = sources;
    /** @type {ComputedMap | undefined} */
    this.map = undefined;
    /** @type {string | undefined} whose numbers are offered */
    this.source = undefined;
    this.axes = ["up", "across"].map((word) => {
      const which = element("select", { "aria-label": `New map: ${word}` });
      const ends = ["from", "to"].map((end) => element("input", { type: "number", step: "any", "aria-label": `New map: ${word} ${end}` }));
      which.addEventListener("change", () => this.#offerRange(which, ends));
      return { word, which, ends };
    });
    this.side = element("select", { "aria-label": "New map: points" }, ...SIDES.map((side) => element("option", { value: side }, `${side} × ${side} points`)));
    this.side.value = String(SIDE);
    this.button = button("Start");
    this.file = button("Table, CSV");
    this.file.disabled = true;
    this.bar = element("progress", { value: 0, max: 1, "aria-label": "Points computed", hidden: true });
    this.words = element("span", { role: "status" });
    const rows = this.axes.map(({ word, which, ends }) => element("div", {}, `${word} `, which, " from ", ends[0], " to ", ends[1]));
    this.root = element("details", { class: "map-form" }, element("summary", {}, "Compute a map of the present touchdown"),
      ...rows, element("div", {}, this.side, this.button, this.file, this.bar, this.words));
    this.root.addEventListener("toggle", () => this.#offer());
    present.addEventListener("units", () => this.#offer());
    present.addEventListener("values", () => present.source !== this.source && this.#offer());
    this.button.addEventListener("click", () => (this.isRunning ? this.map?.stop() : this.#start()));
    this.file.addEventListener("click", () => this.#save());
  }

  /** Offers the numbers of the present touchdown as axes, with the ranges of their sliders. */
  async #offer() {
    if (!this.root.open) return;
    const { touchdown } = this.present;
    this.source = touchdown.source;
    const known = await engine.parameters(touchdown);
    this.parameters = known.filter(({ value, slider, leg, group, name }) =>
      typeof value === "number" && slider && leg === null && group !== "solver" && name !== "horizontal_velocity_fps");
    for (const [index, { which, ends }] of this.axes.entries()) {
      const chosen = which.value || USUAL[index];
      which.replaceChildren(...this.parameters.map((parameter) => element("option", { value: parameter.name }, withUnit(parameter.title, this.#shown(parameter).unit))));
      which.value = chosen;
      this.#offerRange(which, ends);
    }
  }

  /** A number in the units of the page. @param {Parameter} parameter */
  #shown(parameter) {
    return this.present.units === "SI" && parameter.si ? parameter.si : parameter;
  }

  /** @param {HTMLSelectElement} which */
  #chosen(which) {
    const parameter = this.parameters?.find(({ name }) => name === which.value);
    return parameter && this.#shown(parameter);
  }

  /** @param {HTMLSelectElement} which @param {HTMLInputElement[]} ends */
  #offerRange(which, ends) {
    const slider = this.#chosen(which)?.slider;
    if (slider) [ends[0].value, ends[1].value] = [String(slider.from), String(slider.to)];
  }

  async #start() {
    const [slow, fast] = this.axes.map(({ which, ends }) => ({ name: this.#chosen(which)?.name ?? "", from: Number(ends[0].value), to: Number(ends[1].value) }));
    const { touchdown } = this.present;
    const search = this.sources.find(({ name }) => name === touchdown.source)?.search ?? { from_fps: 0, to_fps: 25 };
    const map = new ComputedMap(touchdown, [slow, fast], Number(this.side.value), search);
    this.map = map;
    this.isRunning = true;
    this.button.textContent = "Stop";
    this.file.disabled = true;
    this.bar.hidden = false;
    map.addEventListener("point", () => this.#tell(map));
    map.addEventListener("grown", () => this.dispatchEvent(new Event("grown")));
    this.#tell(map);
    try {
      if (!(slow.from < slow.to && fast.from < fast.to)) throw new Error("expected ranges that rise");
      await map.run();
      this.words.textContent = `${map.progress.all} points are computed`;
    } catch (error) {
      const words = map.stopping.signal.aborted ? "stopped" : error instanceof Error ? error.message : String(error);
      this.words.textContent = `${words}; ${map.progress.lines.join(" × ")} points are drawn`;
      map.stop();
    }
    this.isRunning = false;
    this.button.textContent = "Start";
    this.file.disabled = map.lines[0].length === 0;
    this.bar.hidden = true;
  }

  /** @param {ComputedMap} map */
  #tell({ progress: { done, all, lines } }) {
    [this.bar.value, this.bar.max] = [done, all];
    this.words.textContent = `${done} of ${all} points; ${lines.join(" × ")} are drawn`;
  }

  /** Hands over the table as far as it is drawn. */
  async #save() {
    if (!this.map) return;
    const { files } = await engine.tableFile({ computed: this.map.told, within: [], units: this.present.units });
    for (const { name, text } of files) save(name, text);
  }
}
