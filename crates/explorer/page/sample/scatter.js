import { element } from "../look/elements.js";
import { classColour, colours, onTheme } from "../look/theme.js";
import { scaled } from "../look/text.js";
import { crosshair } from "../map/marks.js";
import { frame } from "./frame.js";

/** @typedef {{ name: string, title: string, values: (number | string | null)[] }} Quantity */
/** @typedef {{ left: number, right: number, low: number, high: number }} Box a rectangle in the units of the quantities */

const ROOM = { left: 62, right: 14, top: 12, bottom: 44 };

/** Landings as points over two quantities, coloured by how they end. A drag selects, a click chooses. */
export class Scatter {
  /** @param {(box: Box | undefined) => void} onBrush @param {(landing: number) => void} onChoose */
  constructor(onBrush, onChoose) {
    this.onBrush = onBrush;
    this.onChoose = onChoose;
    this.canvas = element("canvas", { tabindex: 0, role: "application", "aria-label": "Landings as points; arrow keys go from landing to landing, Enter replays" });
    this.root = element("div", { class: "scatter" }, this.canvas);
    /** @type {[number, number] | undefined} */
    this.pressed = undefined;
    this.canvas.addEventListener("pointerdown", (event) => {
      this.canvas.setPointerCapture(event.pointerId);
      this.pressed = this.#place(event);
    });
    this.canvas.addEventListener("pointermove", (event) => this.pressed && this.#drag(event));
    this.canvas.addEventListener("pointerup", (event) => this.#release(event));
    this.canvas.addEventListener("keydown", (event) => this.#step(event));
    new ResizeObserver(() => this.draw()).observe(this.root);
    onTheme(() => this.draw());
  }

  /**
   * @param {[Quantity, Quantity]} quantities across and up
   * @param {import("../engine/types.js").Class[]} classes of the landings
   */
  set(quantities, classes) {
    this.quantities = quantities;
    this.classes = classes;
    this.box = undefined;
    this.chosen = undefined;
    this.ends = quantities.map(({ values }) => {
      const numbers = values.filter((value) => typeof value === "number");
      const [low, high] = [numbers.reduce((a, b) => Math.min(a, b), Infinity), numbers.reduce((a, b) => Math.max(a, b), -Infinity)];
      const margin = 0.03 * (high - low || 1);
      return numbers.length ? { low: low - margin, high: high + margin } : { low: 0, high: 1 };
    });
    this.draw();
  }

  /** Colours the points, else by how they end. @param {import("./colour_scale.js").ColourScale} [scale] */
  paint(scale) {
    this.scale = scale;
    this.draw();
  }

  /** What is selected, as ranges of columns. @returns {import("../engine/types.js").Range[]} */
  get ranges() {
    const { box, quantities } = this;
    if (!box || !quantities) return [];
    return [{ column: quantities[0].name, from: box.left, to: box.right }, { column: quantities[1].name, from: box.low, to: box.high }];
  }

  get area() {
    const { clientWidth, clientHeight } = this.root;
    const room = scaled(ROOM);
    return { left: room.left, top: room.top, width: clientWidth - room.left - room.right, height: clientHeight - room.top - room.bottom };
  }

  /** Shares of the width and height of the chart. @param {number} landing @returns {[number, number] | undefined} */
  #shares(landing) {
    const { quantities, ends } = this;
    if (!quantities || !ends) return undefined;
    const shares = quantities.map(({ values }, axis) => {
      const value = values[landing];
      return typeof value === "number" ? (value - ends[axis].low) / (ends[axis].high - ends[axis].low) : NaN;
    });
    return shares.every(Number.isFinite) ? [shares[0], shares[1]] : undefined;
  }

  /** @param {MouseEvent} event @returns {[number, number]} shares */
  #place(event) {
    const box = this.canvas.getBoundingClientRect();
    const { left, top, width, height } = this.area;
    return [(event.clientX - box.left - left) / width, 1 - (event.clientY - box.top - top) / height];
  }

  /** @param {MouseEvent} event */
  #drag(event) {
    if (!this.pressed) return;
    const [x, y] = this.#place(event);
    const [u, v] = this.pressed;
    if (Math.hypot(x - u, y - v) < 0.012) return;
    this.select([Math.min(x, u), Math.max(x, u), Math.min(y, v), Math.max(y, v)]);
  }

  /** What is selected, as shares of width and height: from and to across, from and to up. @returns {number[] | undefined} */
  get brush() {
    const { box, ends } = this;
    if (!box || !ends) return undefined;
    const share = (/** @type {number} */ axis, /** @type {number} */ value) => (value - ends[axis].low) / (ends[axis].high - ends[axis].low);
    return [share(0, box.left), share(0, box.right), share(1, box.low), share(1, box.high)];
  }

  /** Selects what lies within such shares; without any, all. @param {number[]} [brush] */
  select(brush) {
    if (!this.ends) return;
    const value = (/** @type {number} */ axis, /** @type {number} */ share) => {
      const { low, high } = /** @type {{ low: number, high: number }[]} */ (this.ends)[axis];
      return low + share * (high - low);
    };
    this.box = brush && { left: value(0, brush[0]), right: value(0, brush[1]), low: value(1, brush[2]), high: value(1, brush[3]) };
    this.onBrush(this.box);
    this.draw();
  }

  /** @param {MouseEvent} event */
  #release(event) {
    if (!this.pressed) return;
    const [x, y] = this.#place(event);
    const isClick = Math.hypot(x - this.pressed[0], y - this.pressed[1]) < 0.012;
    this.pressed = undefined;
    if (!isClick) return;
    const { width, height } = this.area;
    let best = -1;
    let least = 18;
    for (const landing of this.classes?.keys() ?? []) {
      const at = this.#shares(landing);
      const distance = at ? Math.hypot((at[0] - x) * width, (at[1] - y) * height) : Infinity;
      if (distance < least) [best, least] = [landing, distance];
    }
    if (best >= 0) {
      this.choose(best);
      this.onChoose(best);
    } else {
      this.select();
    }
  }

  /** @param {KeyboardEvent} event */
  #step(event) {
    const count = this.classes?.length ?? 0;
    const by = /** @type {Record<string, number>} */ ({ ArrowLeft: -1, ArrowRight: 1, ArrowUp: 10, ArrowDown: -10 })[event.key];
    if (event.key === "Enter" && this.chosen !== undefined) this.onChoose(this.chosen);
    if (!by || !count) return;
    event.preventDefault();
    this.choose(((this.chosen ?? 0) + by + count) % count);
  }

  /** @param {number} landing */
  choose(landing) {
    this.chosen = landing;
    this.draw();
  }

  /** Whether a landing lies within what is selected. @param {number} landing */
  isSelected(landing) {
    const { box, quantities } = this;
    if (!box || !quantities) return true;
    const [x, y] = quantities.map(({ values }) => values[landing]);
    return typeof x === "number" && typeof y === "number" && x >= box.left && x <= box.right && y >= box.low && y <= box.high;
  }

  draw() {
    const { quantities, ends, classes } = this;
    const { clientWidth, clientHeight } = this.root;
    if (!quantities || !ends || !classes || clientWidth < 80) return;
    const ratio = window.devicePixelRatio;
    [this.canvas.width, this.canvas.height] = [clientWidth * ratio, clientHeight * ratio];
    const context = /** @type {CanvasRenderingContext2D} */ (this.canvas.getContext("2d"));
    context.scale(ratio, ratio);
    const { area } = this;
    const now = colours();
    const px = (/** @type {number} */ share) => area.left + share * area.width;
    const py = (/** @type {number} */ share) => area.top + (1 - share) * area.height;
    const { x, y } = frame(context, area, [ends[0], ends[1]], [quantities[0].title, quantities[1].title]);
    const radius = classes.length > 4000 ? 1.6 : classes.length > 800 ? 2.4 : 3.6;
    context.lineWidth = 0.6;
    context.strokeStyle = now.text;
    for (const [landing, of] of classes.entries()) {
      const at = this.#shares(landing);
      if (!at) continue;
      context.globalAlpha = this.isSelected(landing) ? 0.85 : 0.14;
      context.fillStyle = this.scale ? (this.scale.colour(landing) ?? now.paper) : classColour(of);
      context.beginPath();
      // Shape tells stable landings from others too.
      if (of === "stable") context.arc(px(at[0]), py(at[1]), radius, 0, 2 * Math.PI);
      else context.rect(px(at[0]) - radius, py(at[1]) - radius, 2 * radius, 2 * radius);
      context.fill();
      // The ends of a scale are as pale or as dark as the paper.
      if (this.scale) context.stroke();
    }
    context.globalAlpha = 1;
    if (this.box) {
      const { left, right, low, high } = this.box;
      context.strokeStyle = now.jump;
      context.lineWidth = 1.5;
      context.strokeRect(x(left), y(high), x(right) - x(left), y(low) - y(high));
    }
    const at = this.chosen === undefined ? undefined : this.#shares(this.chosen);
    if (at) crosshair(context, px(at[0]), py(at[1]), now.text, now.paper);
  }
}
