/** What the page shows at present: a touchdown, the units, and what was changed of it. */

/** @typedef {import("../engine/types.js").Touchdown} Touchdown */
/** @typedef {import("../engine/types.js").Units} Units */

export class Present extends EventTarget {
  constructor() {
    super();
    /** Name of the source. */
    this.source = "";
    /** @type {string | undefined} text of a vehicle file in place of that of the source */
    this.vehicle = undefined;
    /** @type {Record<string, number | string>} */
    this.values = {};
    /** @type {Units} */
    this.units = "US";
    /** Whether a slider is being dragged. */
    this.isMoving = false;
  }

  /** As requests have it. @returns {Touchdown} */
  get touchdown() {
    const { source, vehicle } = this;
    return { source, ...(vehicle === undefined ? {} : { vehicle }), values: { ...this.values } };
  }

  /**
   * Changes one number; `undefined` gives back that of the source.
   * @param {string} name
   * @param {number | string | undefined} value
   * @param {boolean} [isMoving]
   */
  set(name, value, isMoving = false) {
    if (value === undefined) delete this.values[name];
    else this.values[name] = value;
    this.isMoving = isMoving;
    this.#tell("values", name);
  }

  /** Shows another touchdown, which is told as `replaced`, too. @param {Touchdown} touchdown */
  replace(touchdown) {
    this.#tell("replaced", "");
    if (touchdown.source !== undefined) this.source = touchdown.source;
    this.vehicle = touchdown.vehicle;
    this.values = { ...(touchdown.values ?? {}) };
    this.isMoving = false;
    this.#tell("values", "");
  }

  /** @param {Units} units */
  setUnits(units) {
    this.units = units;
    this.#tell("units", "");
  }

  /** @param {string} kind @param {string} name */
  #tell(kind, name) {
    this.dispatchEvent(new CustomEvent(kind, { detail: { name } }));
  }
}
