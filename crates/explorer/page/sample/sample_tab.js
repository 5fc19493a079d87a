import * as engine from "../engine/engine.js";
import { Newest } from "../engine/newest.js";
import { Replay } from "../landing/replay.js";
import { button, element } from "../look/elements.js";
import { classColour, onTheme } from "../look/theme.js";
import { label, subscripted, withUnit } from "../look/words.js";
import { Scatter } from "./scatter.js";

/** @typedef {import("../engine/types.js").Sample} Sample */

/** Standard deviations on either side of a mean that hold 95 % of a normal distribution. */
const SIGMAS = 1.959963984540054;

/** The 95 % interval of a probability, after Wilson, in percent. @param {number} count @param {number} all */
function interval(count, all) {
  const [share, spread] = [count / all, SIGMAS ** 2 / all];
  const middle = (share + spread / 2) / (1 + spread);
  const half = (SIGMAS / (1 + spread)) * Math.sqrt((share * (1 - share)) / all + spread / (4 * all));
  const percent = (/** @type {number} */ end) => label(100 * Math.min(Math.max(end, 0), 1), 3);
  // The ends are 0 and 1 themselves where all or none end so.
  return `${count === 0 ? 0 : percent(middle - half)} to ${count === all ? 100 : percent(middle + half)} %`;
}

/** Landings of a sample: points over any two of their numbers, what is selected of them, and a replay of any one. */
export class SampleTab extends EventTarget {
  /**
   * @param {import("../engine/types.js").ResultsEntry[]} results
   * @param {import("../present/present.js").Present} present
   */
  constructor(results, present) {
    super();
    this.results = results;
    /** @type {Record<string, string> | undefined} what an address asks for */
    this.wanted = undefined;
    /** @type {string | undefined} the sample that is shown */
    this.name = undefined;
    /** @type {number | undefined} the landing that is replayed */
    this.landing = undefined;
    this.present = present;
    this.newest = new Newest();
    this.which = element("select", { "aria-label": "Sample" }, ...results.map(({ name, title }) => element("option", { value: name }, title)));
    this.across = element("select", { "aria-label": "Across" });
    this.up = element("select", { "aria-label": "Up" });
    this.title = element("h2");
    this.scatter = new Scatter(() => this.#selected(), (landing) => void this.replayOne(landing));
    this.counts = element("div", { class: "counts", role: "status" });
    this.reading = element("p", { class: "reading" }, "Drag a rectangle to select landings; click one to replay it.");
    this.explore = button("Explore this landing");
    this.explore.hidden = true;
    this.replay = new Replay(["The landing that was chosen"]);
    this.replay.root.hidden = true;
    this.root = element("section", { class: "sample-tab" },
      element("div", { class: "map-head" }, element("label", {}, "Sample ", this.which), element("label", {}, "across ", this.across), element("label", {}, "up ", this.up)),
      this.title,
      element("div", { class: "plane" }, this.scatter.root, element("div", { class: "chosen" }, this.counts, this.reading, this.explore)),
      this.replay.root);
    this.which.addEventListener("change", () => this.load(this.which.value));
    present.addEventListener("units", () => this.#convert());
    for (const select of [this.across, this.up]) select.addEventListener("change", () => this.#draw());
    this.explore.addEventListener("click", () => {
      if (this.chosen) this.dispatchEvent(new CustomEvent("explore", { detail: this.chosen }));
    });
    onTheme(() => this.#count());
  }

  /** Loads what was asked for, or the first sample, when the tab is first seen. */
  async open() {
    if (this.sample || this.isOpening) return;
    this.isOpening = true;
    const { sample, over, brush, landing } = this.wanted ?? {};
    const known = this.results.some(({ name }) => name === sample);
    await this.load(known && sample ? sample : this.results[0].name, over?.split(","));
    this.isOpening = false;
    const shares = brush?.split(",").map(Number);
    if (shares?.length === 4 && shares.every(Number.isFinite)) this.scatter.select(shares);
    if (landing) await this.replayOne(Number(landing) - 1);
  }

  /** What an address holds of the sample. */
  state() {
    if (!this.sample || !this.name) return this.wanted ?? {};
    return {
      sample: this.name === this.results[0].name ? "" : this.name,
      over: `${this.across.value},${this.up.value}`,
      brush: this.scatter.brush?.map((share) => share.toFixed(4)).join(",") ?? "",
      landing: this.landing === undefined ? "" : String(this.landing + 1),
    };
  }

  /** @param {Record<string, string>} extra of an address */
  restore({ sample, over, brush, landing }) {
    if (!sample && !over) return;
    const wanted = { sample: sample ?? this.results[0].name, over, brush, landing };
    this.wanted = Object.fromEntries(Object.entries(wanted).filter(([, text]) => text));
    this.sample = undefined;
  }

  /** @param {string} name @param {string[]} [axes] */
  async load(name, axes) {
    this.which.value = name;
    const sample = await engine.sample({ results: name, units: this.present.units });
    if (name !== this.name) this.replay.root.hidden = this.explore.hidden = true;
    this.name = name;
    this.landing = undefined;
    this.sample = sample;
    this.title.replaceChildren(subscripted(sample.title));
    this.quantities = [...sample.inputs, ...sample.results].filter(({ values }) => values.some((value) => typeof value === "number"));
    for (const [index, select] of [this.across, this.up].entries()) {
      select.replaceChildren(...this.quantities.map((quantity) => element("option", { value: quantity.name }, withUnit(quantity.title, quantity.unit))));
      const names = this.quantities.map(({ name: known }) => known);
      const usual = index === 0 ? names.find((known) => known.startsWith("horizontal_velocity_")) ?? names[0] : names.find((known) => known !== this.across.value);
      select.value = String(names.find((known) => known === axes?.[index]) ?? usual);
    }
    this.#draw();
    this.dispatchEvent(new Event("loaded"));
  }

  /** Shows the same in other units. */
  async #convert() {
    const { name, scatter, landing } = this;
    if (!name) return;
    const { brush } = scatter;
    const places = [this.across, this.up].map(({ selectedIndex }) => selectedIndex);
    await this.load(name);
    [this.across.selectedIndex, this.up.selectedIndex] = places;
    this.#draw();
    scatter.select(brush);
    if (landing !== undefined) await this.replayOne(landing);
  }

  #draw() {
    const { sample, quantities } = this;
    if (!sample || !quantities) return;
    const of = (/** @type {string} */ name) => {
      const found = quantities.find((quantity) => quantity.name === name) ?? quantities[0];
      return { title: withUnit(found.title, found.unit), values: found.values };
    };
    this.scatter.set([of(this.across.value), of(this.up.value)], sample.class.map((index) => sample.classes[index].class));
    this.#count();
    this.dispatchEvent(new Event("axes"));
  }

  #selected() {
    this.#count();
    this.dispatchEvent(new Event("selected"));
  }

  /** How those end that are selected. */
  #count() {
    const { sample } = this;
    if (!sample) return;
    /** @type {Map<string, number>} */
    const counts = new Map();
    let all = 0;
    for (const [landing, index] of sample.class.entries()) {
      if (!this.scatter.isSelected(landing)) continue;
      all += 1;
      counts.set(sample.classes[index].class, (counts.get(sample.classes[index].class) ?? 0) + 1);
    }
    const rows = sample.classes.map((kind) => {
      const count = counts.get(kind.class) ?? 0;
      const dot = element("span", { class: "dot" });
      dot.style.background = classColour(kind.class);
      return element("tr", {}, element("th", { scope: "row" }, dot, ` ${kind.word}`), element("td", {}, String(count)),
        element("td", {}, all ? `${label((100 * count) / all, 3)} %` : "–"), element("td", {}, all ? interval(count, all) : ""));
    });
    const head = element("caption", {}, this.scatter.box ? `${all} of ${sample.class.length} landings are selected` : `${all} landings`, ", with 95 % intervals");
    this.counts.replaceChildren(element("table", {}, head, element("tbody", {}, ...rows)));
  }

  /** Lands one of the sample again. @param {number} landing */
  async replayOne(landing) {
    const { sample } = this;
    if (sample?.class[landing] === undefined) return;
    /** @type {Record<string, number | string>} */
    const values = {};
    for (const input of sample.inputs) {
      const { name, values: given } = input.written ?? input;
      const value = given[landing];
      if (value !== null) values[name] = value;
    }
    this.landing = landing;
    this.scatter.choose(landing);
    this.dispatchEvent(new Event("selected"));
    this.chosen = { source: sample.source, values };
    const words = sample.inputs.map(({ title, unit, values: of }) => {
      const value = of[landing];
      return `${title.replace(/,[^,]*$/, "")} ${typeof value === "number" ? label(value, 5) : value}${unit ? ` ${unit}` : ""}`;
    });
    this.reading.replaceChildren(subscripted(`Landing ${landing + 1}, ${sample.outcomes[sample.outcome[landing]]}: ${words.join(", ")}`));
    await this.newest.run(async () => {
      const { units } = this.present;
      this.replay.root.hidden = false;
      this.explore.hidden = false;
      const touchdown = /** @type {import("../engine/types.js").Touchdown} */ (this.chosen);
      const landed = await this.replay.landed(() => engine.landing({ touchdown, units }));
      if (landed) this.replay.show([landed], units);
    });
  }
}
