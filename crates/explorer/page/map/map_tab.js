import * as engine from "../engine/engine.js";
import { Newest } from "../engine/newest.js";
import { Replay } from "../landing/replay.js";
import { button, element } from "../look/elements.js";
import { label, subscripted } from "../look/words.js";
import { BoundaryChart } from "./boundary_chart.js";
import { ContourMap } from "./contour_map.js";
import { legendOf } from "./legend.js";
import { MapForm } from "./map_form.js";
import { partOf, partsOf } from "./parts.js";
import { Sections } from "./sections.js";
import { nearestPoint } from "./view.js";
import { SurfaceView } from "./surface_view.js";

/** @typedef {import("../engine/types.js").MapAnswer} MapAnswer */
/** @typedef {import("../engine/types.js").MapPoint} MapPoint */
/** @typedef {import("../engine/types.js").Touchdown} Touchdown */

/** Name of the map that is computed here. */
const COMPUTED = "";

/** Results of sweeps and maps, and a map that is computed here: contours, surface, sections, and the landings just below and just above the boundary. */
export class MapTab extends EventTarget {
  /**
   * @param {import("../engine/types.js").ResultsEntry[]} results
   * @param {import("../present/present.js").Present} present
   * @param {import("../engine/types.js").Source[]} sources
   */
  constructor(results, present, sources) {
    super();
    /** @type {Record<string, string> | undefined} what an address asks for */
    this.wanted = undefined;
    this.results = results;
    this.present = present;
    const hover = (/** @type {MapPoint | undefined} */ point) => this.#tell(point ?? this.chosen);
    const choose = (/** @type {MapPoint} */ point) => void this.choose(point);
    this.contour = new ContourMap(hover, choose);
    this.surface = new SurfaceView(choose);
    this.sections = new Sections(hover, choose);
    this.profile = new BoundaryChart(hover, choose);
    this.newest = new Newest();
    this.growing = new Newest();
    this.form = new MapForm(present, sources);
    /** The map of the form that was shown last. @type {import("./computed_map.js").ComputedMap | undefined} */
    this.grown = undefined;
    /** @type {MapPoint | undefined} the point whose landings are shown */
    this.chosen = undefined;
    this.which = element("select", { "aria-label": "Results" }, ...results.map(({ name, title }) => element("option", { value: name }, title)));
    this.axes = element("span", { class: "axes" });
    this.title = element("h2");
    this.conditions = element("p", { class: "conditions" });
    this.reading = element("p", { class: "reading", role: "status" });
    this.legend = element("div", { class: "map-legend" });
    this.explore = [button("Explore the landing below"), button("Explore the landing above")];
    this.pair = new Replay(["Just below the boundary", "Just above the boundary"]);
    const captions = element("div", { class: "pair-captions" }, ...this.explore);
    this.pairRoot = element("section", { class: "pair", hidden: true, "aria-label": "Landings below and above the boundary" },
      element("h2", {}, "Just below the boundary, and just above it"), captions, this.pair.root);
    this.head = element("div", { class: "map-head" }, element("label", {}, "Results ", this.which), this.axes);
    this.plane = element("div", { class: "plane" }, this.contour.root, this.surface.root);
    this.root = element("section", { class: "map-tab" },
      this.form.root, this.head, this.title, this.conditions, this.plane, this.profile.root, this.legend, this.reading, this.sections.root, this.pairRoot);
    for (const part of [this.head, this.plane, this.profile.root, this.sections.root]) part.hidden = true;
    this.form.addEventListener("grown", () => this.#grow());
    this.which.addEventListener("change", () => this.load(this.which.value));
    present.addEventListener("units", () => this.#convert());
    this.explore.forEach((made, index) => made.addEventListener("click", () => {
      const touchdown = this.ends?.[index];
      if (touchdown) this.dispatchEvent(new CustomEvent("explore", { detail: touchdown }));
    }));
  }

  /** Loads what was asked for, or the first results, when the tab is first seen. */
  async open() {
    if (this.map || this.isOpening) return;
    if (this.results.length === 0) {
      this.form.root.open = true;
      return;
    }
    this.isOpening = true;
    const { results, axes, at, fixed, part } = this.wanted ?? {};
    const known = this.results.some(({ name }) => name === results);
    await (known && results ? this.load(results, axes?.split(","), valuesIn(fixed)) : this.load(this.results[0].name));
    const rows = this.whole && part ? partsOf(this.whole)[Number(part)] : undefined;
    if (this.whole && rows) this.#show(this.whole, rows);
    this.isOpening = false;
    const place = at?.split(",").map(Number);
    if (!known || !place || !this.map || place.some(Number.isNaN)) return;
    const point = nearestPoint(this.map, place[0], place[1] ?? 0);
    if (point) await this.choose(point);
  }

  /** What an address holds of the map. */
  state() {
    if (!this.map || !this.name) return this.map ? {} : (this.wanted ?? {});
    return {
      results: this.name === this.results[0].name ? "" : this.name,
      axes: this.map.axes.length > 1 ? this.map.axes.map(({ name }) => name).join(",") : "",
      fixed: Object.entries(fixedOf(this.map)).map((entry) => entry.join(":")).join(","),
      part: this.#part(),
      at: this.chosen ? this.chosen.place.join(",") : "",
    };
  }

  /** Number of the part that is shown, if it is not the last. */
  #part() {
    const parts = this.whole ? partsOf(this.whole) : [];
    const number = parts.findIndex(([first]) => first === this.rows?.[0]);
    return number < 0 || number === parts.length - 1 ? "" : String(number);
  }

  /** @param {Record<string, string>} extra of an address */
  restore({ results, axes, at, fixed, part }) {
    if ((!results && !axes && !at && !part) || this.results.length === 0) return;
    const wanted = { results: results ?? this.results[0].name, axes, at, fixed, part };
    this.wanted = Object.fromEntries(Object.entries(wanted).filter(([, text]) => text));
    this.map = undefined;
  }

  /**
   * Shows results.
   * @param {string} name
   * @param {string[]} [axes]
   * @param {Record<string, number | string>} [fixed]
   * @param {[number, number]} [rows] that are shown, else those of the last part
   */
  async load(name, axes, fixed, rows) {
    this.which.value = name;
    const { units } = this.present;
    const isSame = name === this.name;
    const map = await engine.map({ ...this.#asked(name), units, ...(axes ? { axes } : {}), ...(fixed ? { fixed } : {}) });
    this.name = name;
    this.whole = map;
    const parts = partsOf(map);
    this.#show(map, rows ?? parts[parts.length - 1], isSame && name === COMPUTED);
  }

  /** How requests name the results that are shown. @param {string} name */
  #asked(name) {
    return name === COMPUTED && this.form.map ? { computed: this.form.map.told } : { results: name };
  }

  /** Shows the map that is computed here as far as it is, unless others have been chosen meanwhile. */
  #grow() {
    const { map } = this.form;
    if (map !== this.grown) {
      this.grown = map;
      if (![...this.which.options].some(({ value }) => value === COMPUTED)) this.which.append(element("option", { value: COMPUTED }, "computed here"));
      this.which.value = COMPUTED;
    }
    if (this.which.value === COMPUTED) void this.growing.run(() => this.load(COMPUTED));
  }

  /** Shows the same in other units. */
  async #convert() {
    const { whole, name, chosen, rows } = this;
    if (!whole || name === undefined) return;
    const place = chosen?.place.join();
    const index = whole.points.findIndex((point) => point.place.join() === place);
    await this.load(name, whole.axes.map((axis) => axis.name), fixedOf(whole), rows);
    const point = this.whole?.points[index];
    if (point) await this.choose(point);
  }

  /** @param {MapAnswer} whole @param {[number, number]} rows that are shown @param {boolean} [hasGrown] whether it keeps the point that is chosen */
  #show(whole, rows, hasGrown = false) {
    const map = partOf(whole, rows);
    const place = hasGrown ? this.chosen?.place.join() : undefined;
    this.map = map;
    this.rows = rows;
    this.chosen = map.points.find((point) => point.place.join() === place);
    if (!this.chosen) this.pairRoot.hidden = true;
    this.head.hidden = false;
    this.title.replaceChildren(subscripted(map.title));
    this.conditions.textContent = [map.conditions, map.statement].filter(Boolean).join(" · ");
    const isMap = map.axes.length > 1;
    // Points that no surface joins have neither a surface nor sections.
    const isJoined = map.grid !== null || map.triangles !== null;
    this.plane.hidden = !isMap;
    this.surface.root.hidden = !isJoined;
    this.sections.root.hidden = !isMap || !isJoined;
    this.profile.root.hidden = isMap;
    this.#writeAxes();
    this.legend.replaceChildren(...legendOf(map));
    if (isMap) {
      this.contour.set(map);
      this.contour.choose(this.chosen);
      this.surface.set(map);
      this.surface.choose(this.chosen);
      const shown = this.chosen ?? lowest(map.points);
      if (shown) this.sections.show(map, shown);
    } else {
      this.#showProfile();
    }
    this.#tell(this.chosen);
    this.dispatchEvent(new Event("loaded"));
  }

  #showProfile() {
    const { map } = this;
    if (!map) return;
    const places = map.points.map((point) => ({ x: point.place[0], point, breaks: false })).sort((a, b) => a.x - b.x);
    this.profile.set({ title: map.axes[0].title, note: "", unit: map.speed_unit, places, isTurned: false, chosen: this.chosen?.place[0] ?? null });
  }

  /** Which two axes, and where along the others. */
  #writeAxes() {
    const { map, name } = this;
    this.axes.replaceChildren();
    if (!map || name === undefined || map.axes.length < 2) return;
    const all = [...map.axes, ...map.other_axes];
    const fixed = fixedOf(map);
    const names = map.axes.map((axis) => axis.name);
    for (const [index, word] of ["up", "across"].entries()) {
      const select = element("select", { "aria-label": `Axis ${word}` }, ...all.map((axis) => element("option", { value: axis.name }, axis.title)));
      select.value = names[index];
      select.addEventListener("change", () => {
        const wanted = [...names];
        // The other axis goes where this one was.
        const other = wanted.indexOf(select.value);
        if (other >= 0) wanted[other] = names[index];
        wanted[index] = select.value;
        this.load(name, wanted, Object.fromEntries(Object.entries(fixed).filter(([key]) => !wanted.includes(key))));
      });
      this.axes.append(element("label", {}, `${word} `, select));
    }
    for (const axis of map.other_axes) {
      const select = element("select", { "aria-label": axis.title }, ...axis.values.map((value) => element("option", {}, typeof value === "number" ? label(value) : value)));
      select.selectedIndex = Math.max(axis.values.indexOf(/** @type {number} */ (axis.fixed)), 0);
      select.addEventListener("change", () => this.load(name, names, { ...fixed, [axis.name]: axis.values[select.selectedIndex] }));
      this.axes.append(element("label", {}, `${axis.title} `, select));
    }
    this.#writeParts();
  }

  #writeParts() {
    const { whole } = this;
    if (!whole) return;
    const parts = partsOf(whole);
    if (parts.length < 2) return;
    const { title, values } = whole.axes[0];
    const options = parts.map(([first, last]) => element("option", { value: first }, `${label(values[first])} to ${label(values[last])}`));
    const select = element("select", { "aria-label": `Part of ${title}` }, ...options);
    select.value = String(this.rows?.[0] ?? 0);
    select.addEventListener("change", () => this.#show(whole, parts[select.selectedIndex]));
    this.axes.append(element("label", {}, "part ", select));
  }

  /** Writes what is known of a point. @param {MapPoint | undefined} point */
  #tell(point) {
    const { map } = this;
    if (!map) return;
    if (!point) {
      this.reading.textContent = "Point at the map to read a value; click to land just below and just above the boundary there.";
      return;
    }
    const where = map.axes.map(({ title, unit }, axis) => `${title.replace(/,[^,]*$/, "")} ${label(point.place[axis])}${unit ? ` ${unit}` : ""}`).join(", ");
    const kind = map.kinds.find((known) => known.class === point.to)?.word ?? "";
    const value = point.speed === null
      ? (map.words.gap || (map.searched_to === null ? "no transition" : `stable up to ${label(map.searched_to)} ${map.speed_unit}`))
      : `V_H = ${label(point.speed, 7)} ${map.speed_unit}, above: ${kind}`;
    const bracket = point.low !== null && point.high !== null ? `, between ${label(point.low, 8)} and ${label(point.high, 8)}` : "";
    // Where there is no transition, or none above the lowest speed, that is all there is to say.
    const certain = point.certainty === "certain" || point.certainty === "disputed" ? `; ${point.certainty}` : "";
    const disputed = point.disputed ? ` from ${label(point.disputed[0], 7)} to ${label(point.disputed[1], 7)}` : "";
    const patchy = point.patchy_to === null ? "" : `; patchy up to ${label(point.patchy_to, 7)}`;
    this.reading.replaceChildren(subscripted(`${where}: ${value}${bracket}${certain}${disputed}${patchy}`));
  }

  /** Lands on both sides of the boundary at a point. @param {MapPoint} point */
  async choose(point) {
    const { map, name } = this;
    if (!map || name === undefined) return;
    this.chosen = point;
    if (map.axes.length > 1) {
      this.contour.choose(point);
      this.surface.choose(point);
      this.sections.show(map, point);
    } else {
      this.#showProfile();
    }
    this.#tell(point);
    await this.newest.run(async () => {
      const { units } = this.present;
      const place = Object.fromEntries([
        ...map.axes.map((axis, index) => [axis.name, point.place[index]]),
        ...Object.entries(fixedOf(map)),
      ]);
      this.pairRoot.hidden = false;
      const landings = await this.pair.landed(async () => {
        const at = await engine.at({ ...this.#asked(name), place, units });
        this.ends = [at.below, at.above];
        const wanted = this.ends.flatMap((touchdown) => (touchdown ? [touchdown] : []));
        return Promise.all(wanted.map((touchdown) => engine.landing({ touchdown, units })));
      });
      if (!landings || !this.ends) return;
      this.pair.panels.forEach(({ root }, index) => (root.hidden = this.ends?.[index] === null));
      this.explore.forEach((made, index) => (made.hidden = this.ends?.[index] === null));
      this.pair.show(landings, units, this.ends.flatMap((touchdown, index) => (touchdown ? [index] : [])));
      this.dispatchEvent(new Event("landed"));
    });
  }
}

/** Values by name of an address. @param {string | undefined} text @returns {Record<string, number | string> | undefined} */
function valuesIn(text) {
  const pairs = text?.split(",").map((pair) => pair.split(":"));
  return pairs && Object.fromEntries(pairs.map(([name, value]) => [name, Number.isFinite(Number(value)) ? Number(value) : value]));
}

/** Where along the axes that are not drawn over. @param {MapAnswer} map @returns {Record<string, number | string>} */
const fixedOf = (map) => Object.fromEntries(map.other_axes.map((axis) => [axis.name, axis.fixed ?? axis.values[0]]));

/** The point with the lowest transition. @param {MapPoint[]} points */
function lowest(points) {
  const known = points.filter(({ speed }) => speed !== null);
  return known.reduce((best, point) => (Number(point.speed) < Number(best.speed) ? point : best), known[0]) ?? points[0];
}
