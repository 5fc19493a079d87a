import * as engine from "../engine/engine.js";
import { Newest } from "../engine/newest.js";
import { Replay } from "../landing/replay.js";
import { button, element } from "../look/elements.js";
import { classColour, onTheme } from "../look/theme.js";
import { label, subscripted, withUnit } from "../look/words.js";
import { save } from "../take/save.js";
import { interval, SampleBins } from "./bins.js";
import { ColourScale } from "./colour_scale.js";
import { Scatter } from "./scatter.js";

/** @typedef {import("../engine/types.js").Sample} Sample */

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
    this.counting = new Newest();
    this.which = element("select", { "aria-label": "Sample" }, ...results.map(({ name, title }) => element("option", { value: name }, title)));
    this.across = element("select", { "aria-label": "Across" });
    this.up = element("select", { "aria-label": "Up" });
    this.colour = element("select", { "aria-label": "Colour" });
    this.scale = element("div");
    this.bins = new SampleBins();
    this.file = button("Selected landings, CSV");
    this.title = element("h2");
    this.scatter = new Scatter(() => this.#selected(), (landing) => void this.replayOne(landing));
    this.counts = element("div", { class: "counts", role: "status" });
    this.reading = element("p", { class: "reading" }, "Drag a rectangle to select landings; click one to replay it.");
    this.explore = button("Explore this landing");
    this.explore.hidden = true;
    this.replay = new Replay(["The landing that was chosen"]);
    this.replay.root.hidden = true;
    this.root = element("section", { class: "sample-tab" },
      element("div", { class: "map-head" }, element("label", {}, "Sample ", this.which), element("label", {}, "across ", this.across), element("label", {}, "up ", this.up), element("label", {}, "colour ", this.colour)),
      this.title,
      element("div", { class: "plane" }, element("div", {}, this.scatter.root, this.scale), element("div", { class: "chosen" }, this.counts, this.file, this.reading, this.explore)),
      this.bins.root, this.replay.root);
    this.which.addEventListener("change", () => this.load(this.which.value));
    present.addEventListener("units", () => this.#convert());
    for (const select of [this.across, this.up]) select.addEventListener("change", () => this.#draw());
    this.colour.addEventListener("change", () => this.#paint());
    this.bins.over.addEventListener("change", () => this.#selected());
    this.file.addEventListener("click", () => this.#save());
    this.explore.addEventListener("click", () => {
      if (this.chosen) this.dispatchEvent(new CustomEvent("explore", { detail: this.chosen }));
    });
    onTheme(() => this.#write());
  }

  /** Loads what was asked for, or the first sample, when the tab is first seen. */
  async open() {
    if (this.sample || this.isOpening) return;
    this.isOpening = true;
    const { sample, brush, landing } = this.wanted ?? {};
    const known = this.results.some(({ name }) => name === sample);
    await this.load(known && sample ? sample : this.results[0].name, this.wanted);
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
      colour: this.colour.value,
      bins: this.bins.over.value,
      brush: this.scatter.brush?.map((share) => share.toFixed(4)).join(",") ?? "",
      landing: this.landing === undefined ? "" : String(this.landing + 1),
    };
  }

  /** @param {Record<string, string>} extra of an address */
  restore({ sample, over, colour, bins, brush, landing }) {
    if (!sample && !over && !colour && !bins) return;
    const wanted = { sample: sample ?? this.results[0].name, over, colour, bins, brush, landing };
    this.wanted = Object.fromEntries(Object.entries(wanted).filter(([, text]) => text));
    this.sample = undefined;
  }

  /** @param {string} name @param {Record<string, string>} [wanted] columns that are shown */
  async load(name, wanted = {}) {
    this.which.value = name;
    const sample = await engine.sample({ results: name, units: this.present.units });
    if (name !== this.name) this.replay.root.hidden = this.explore.hidden = true;
    this.name = name;
    this.landing = undefined;
    this.sample = sample;
    this.title.replaceChildren(subscripted(sample.title));
    this.quantities = [...sample.inputs, ...sample.results].filter(({ values }) => values.some((value) => typeof value === "number"));
    const names = this.quantities.map(({ name: known }) => known);
    const first = names.find((known) => known.startsWith("horizontal_velocity_")) ?? names[0];
    const [across, up] = wanted.over?.split(",") ?? [];
    const chosen = (/** @type {string | undefined} */ column, /** @type {string | undefined} */ usual) => names.find((known) => known === column) ?? usual ?? first;
    for (const select of [this.across, this.up, this.colour, this.bins.over]) {
      select.replaceChildren(...this.quantities.map((quantity) => element("option", { value: quantity.name }, withUnit(quantity.title, quantity.unit))));
    }
    this.colour.prepend(element("option", { value: "" }, "how it ends"));
    this.across.value = chosen(across, first);
    this.up.value = chosen(up, names.find((known) => known !== this.across.value));
    this.colour.value = chosen(wanted.colour, "");
    this.bins.over.value = chosen(wanted.bins, this.across.value);
    this.#draw();
    this.dispatchEvent(new Event("loaded"));
  }

  /** Shows the same in other units. */
  async #convert() {
    const { name, scatter, landing } = this;
    if (!name) return;
    const { brush } = scatter;
    const selects = [this.across, this.up, this.colour, this.bins.over];
    const places = selects.map(({ selectedIndex }) => selectedIndex);
    await this.load(name);
    selects.forEach((select, index) => (select.selectedIndex = places[index]));
    this.#draw();
    scatter.select(brush);
    if (landing !== undefined) await this.replayOne(landing);
  }

  /** A column that is shown. @param {string} name */
  #quantity(name) {
    const found = this.quantities?.find((quantity) => quantity.name === name);
    return found && { name, title: withUnit(found.title, found.unit), values: found.values };
  }

  #draw() {
    const [across, up] = [this.across, this.up].map(({ value }) => this.#quantity(value));
    const { sample } = this;
    if (!sample || !across || !up) return;
    this.scatter.set([across, up], sample.class.map((index) => sample.classes[index].class));
    this.#paint();
    this.#count();
    this.dispatchEvent(new Event("axes"));
  }

  #paint() {
    const quantity = this.#quantity(this.colour.value);
    const scale = quantity && this.sample && new ColourScale(quantity, this.sample.ramp);
    this.scale.replaceChildren(...(scale ? [scale.root] : []));
    this.scatter.paint(scale);
    this.dispatchEvent(new Event("axes"));
  }

  #selected() {
    this.#count();
    this.dispatchEvent(new Event("selected"));
  }

  /** How those end that are selected, of all and over bins. */
  async #count() {
    this.counts.setAttribute("aria-busy", "true");
    await this.counting.run(async () => {
      const { name, sample, bins, present, scatter } = this;
      const column = this.#quantity(bins.over.value);
      if (!name || !sample || !column) return;
      this.counted = await engine.bins({ results: name, column: column.name, within: scatter.ranges, units: present.units });
      bins.show(this.counted, sample.classes, column.title);
      this.#write();
    });
    this.counts.setAttribute("aria-busy", "false");
  }

  #write() {
    const { sample, counted } = this;
    if (!sample || !counted) return;
    const { landings, classes } = counted.within;
    const rows = sample.classes.map((kind, place) => {
      const of = classes[place];
      const dot = element("span", { class: "dot" });
      dot.style.background = classColour(kind.class);
      return element("tr", {}, element("th", { scope: "row" }, dot, ` ${kind.word}`), element("td", {}, String(of.landings)),
        element("td", {}, of.probability === null ? "–" : `${label(100 * of.probability, 3)} %`), element("td", {}, landings ? interval(of) : ""));
    });
    const head = element("caption", {}, this.scatter.box ? `${landings} of ${counted.all.landings} landings are selected` : `${landings} landings`, ", with 95 % intervals");
    this.counts.replaceChildren(element("table", {}, head, element("tbody", {}, ...rows)));
  }

  /** Hands over the rows of what is selected. */
  async #save() {
    if (!this.name) return;
    const { files } = await engine.tableFile({ results: this.name, within: this.scatter.ranges, units: this.present.units });
    for (const { name, text } of files) save(name, text);
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
