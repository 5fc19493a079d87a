import * as engine from "../engine/engine.js";
import { Newest } from "../engine/newest.js";
import { button, element } from "../look/elements.js";
import { inUnit, label, subscripted } from "../look/words.js";

/** @typedef {import("../engine/types.js").Touchdown} Touchdown */
/** @typedef {import("../engine/types.js").Parameter} Parameter */
/** @typedef {import("../engine/types.js").Landing} Landing */
/** @typedef {{ touchdown: Touchdown, landing: Landing, parameters: Parameter[] }} Entry */

/** Greatest number of landings that are kept, and of differences that their names tell. */
const MOST = 4;
const TOLD = 3;

/** Landings that are kept, so that the histories of others are compared with theirs. */
export class Kept extends EventTarget {
  /** @param {import("../present/present.js").Present} present */
  constructor(present) {
    super();
    this.present = present;
    this.newest = new Newest();
    /** @type {Touchdown[]} */
    this.touchdowns = [];
    /** @type {Entry[]} as they were landed, in the units that are shown */
    this.entries = [];
    this.button = button("Keep", "Keep this landing in the charts, to compare others with it");
    this.root = element("ul", { class: "kept", "aria-label": "Landings that are kept" });
    this.button.addEventListener("click", () => this.set([...this.touchdowns, present.touchdown]));
    present.addEventListener("units", () => this.set(this.touchdowns));
  }

  /** Keeps these landings, and no others. @param {Touchdown[]} touchdowns */
  set(touchdowns) {
    this.touchdowns = touchdowns;
    this.button.disabled = touchdowns.length >= MOST;
    return this.newest.run(async () => {
      try {
        this.entries = await Promise.all(touchdowns.map((touchdown) => land(touchdown, this.present.units)));
      } catch (error) {
        this.touchdowns = this.entries = [];
        throw error;
      } finally {
        this.dispatchEvent(new Event("changed"));
      }
    });
  }

  /** Lists what is kept, by names that tell how it differs from what is shown. */
  named() {
    const named = this.entries.map((entry) => ({ landing: entry.landing, name: this.#name(entry) }));
    this.root.replaceChildren(...named.map(({ landing, name }, index) => {
      const dot = element("span", { class: "dot" });
      dot.style.background = `var(--${landing.class})`;
      const remove = button("✕", `Remove ${name}`);
      remove.addEventListener("click", () => this.set(this.touchdowns.filter((_, other) => other !== index)));
      return element("li", {}, dot, element("span", {}, subscripted(`${name}: ${landing.outcome}`)), remove);
    }));
    return named;
  }

  /** @param {Entry} entry */
  #name({ touchdown, parameters }) {
    const { source, values, units } = this.present;
    const given = touchdown.values ?? {};
    const differences = parameters.flatMap(({ name, title, value, unit, si }) => {
      const names = [name, si?.name ?? name];
      const here = names.find((one) => one in values);
      const there = names.find((one) => one in given);
      if (!here && !there) return [];
      if (here && values[here] === (given[here] ?? (here === name ? value : si?.value))) return [];
      const shown = units === "SI" && si ? si : { value, unit };
      return [`${title} ${typeof shown.value === "string" ? shown.value : label(shown.value)}${inUnit(shown.unit)}`];
    });
    const all = touchdown.source === source ? differences : [String(touchdown.source), ...differences];
    if (all.length === 0) return "the same";
    return all.slice(0, TOLD).join(", ") + (all.length > TOLD ? " …" : "");
  }

  /** What an address holds of them. */
  state() {
    return { keep: this.touchdowns.length ? JSON.stringify(this.touchdowns) : "" };
  }

  /** @param {Record<string, string>} extra of an address */
  async restore({ keep }) {
    await this.set(keep ? JSON.parse(keep).slice(0, MOST) : []);
  }
}

/** @param {Touchdown} touchdown @param {string} units @returns {Promise<Entry>} */
async function land(touchdown, units) {
  const [landing, parameters] = await Promise.all([engine.landing({ touchdown, units, drawing: false }), engine.parameters(touchdown)]);
  return { touchdown, landing, parameters };
}
