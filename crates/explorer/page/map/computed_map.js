import * as engine from "../engine/engine.js";

/** @typedef {import("../engine/types.js").Touchdown} Touchdown */
/** @typedef {{ name: string, from: number, to: number }} Range an axis */

/** Places that are asked for at a time. */
const AT_A_TIME = 4;

/** A map that is computed place by place: a coarse grid first, whose rows and columns are then halved. */
export class ComputedMap extends EventTarget {
  /**
   * @param {Touchdown} touchdown
   * @param {[Range, Range]} axes slow and fast
   * @param {number} side of the grid in points: a power of two, and one
   * @param {{ from_fps: number, to_fps: number }} search
   */
  constructor(touchdown, axes, side, search) {
    super();
    this.touchdown = touchdown;
    this.axes = axes;
    this.side = side;
    this.search = search;
    this.heading = "";
    /** Rows of the table by their places in the full grid. @type {Map<string, string>} */
    this.rows = new Map();
    /** Rows and columns of the grid that are computed. @type {[number[], number[]]} */
    this.lines = [[], []];
    this.stopping = new AbortController();
  }

  /** As requests have it: the lines that are complete. */
  get told() {
    const [slow, fast] = this.lines.map((lines) => [...lines].sort((a, b) => a - b));
    const rows = slow.flatMap((row) => fast.flatMap((column) => this.rows.get(`${row},${column}`) ?? []));
    const table = `${[this.heading, ...rows].join("\n")}\n`;
    return { touchdown: this.touchdown, axes: this.#names, ...this.search, table };
  }

  get #names() {
    return this.axes.map(({ name }) => name);
  }

  /** Points that are computed, and all. */
  get progress() {
    return { done: this.rows.size, all: this.side ** 2, lines: this.lines.map(({ length }) => length) };
  }

  stop() {
    this.stopping.abort();
  }

  /** Computes until the grid is full, or it is stopped. */
  async run() {
    let step = (this.side - 1) / 2;
    const coarse = [0, step, 2 * step];
    this.lines[1] = coarse;
    for (const row of coarse) await this.#line(0, row);
    while (step > 1) {
      step /= 2;
      const halves = Array.from({ length: (this.side - 1) / (2 * step) }, (_, index) => (2 * index + 1) * step);
      for (const axis of [0, 1]) for (const line of halves) await this.#line(axis, line);
    }
  }

  /** Computes a row or a column over all lines of the other axis. @param {number} axis @param {number} line */
  async #line(axis, line) {
    const waiting = this.lines[1 - axis].map((other) => (axis === 0 ? [line, other] : [other, line]));
    const work = async () => {
      for (let place = waiting.shift(); place; place = waiting.shift()) await this.#point(place);
    };
    await Promise.all(Array.from({ length: AT_A_TIME }, work));
    this.lines[axis] = [...this.lines[axis], line];
    this.dispatchEvent(new Event("grown"));
  }

  /** @param {number[]} place in the grid */
  async #point(place) {
    const { signal } = this.stopping;
    signal.throwIfAborted();
    const values = this.axes.map(({ from, to }, axis) => Number((from + ((to - from) * place[axis]) / (this.side - 1)).toPrecision(12)));
    const request = { touchdown: this.touchdown, axes: this.#names, place: values, ...this.search };
    const { heading, row } = await engine.boundary(request, signal);
    this.heading = heading;
    this.rows.set(place.join(), row);
    this.dispatchEvent(new Event("point"));
  }
}
