import { element } from "../look/elements.js";
import { classColour, colours, onTheme } from "../look/theme.js";
import { scaled } from "../look/text.js";
import { label, subscripted, withUnit } from "../look/words.js";
import { frame } from "./frame.js";

/** @typedef {import("../engine/types.js").Bins} Answer */
/** @typedef {import("../engine/types.js").Counted} Counted */
/** @typedef {import("../engine/types.js").Kind} Kind */

const ROOM = { left: 62, right: 14, top: 12, bottom: 44, between: 30 };
/** Part of the width of a bin over which the probabilities of classes lie beside each other. */
const SPREAD = 0.5;

/** The interval of a probability in words. @param {Counted["classes"][0]} counted */
export const interval = ({ low_95, high_95 }) => `${label(100 * low_95, 3)} to ${label(100 * high_95, 3)} %`;

/** A column in bins: how many landings lie in each, and how likely those selected there end in each way. */
export class SampleBins {
  constructor() {
    this.over = element("select", { "aria-label": "Bins of" });
    this.canvas = element("canvas", { role: "img", "aria-label": "Histogram, and probabilities with their 95 % intervals; their numbers are in the table below" });
    this.chart = element("div", { class: "bins-chart" }, this.canvas);
    this.table = element("table");
    this.numbers = element("details", { class: "numbers" }, element("summary", {}, "Numbers of the bins"), this.table);
    const words = "Bars: landings selected, by how they end; outlines: all landings. Below: probabilities of what is selected, with 95 % intervals.";
    this.root = element("section", { class: "bins", "aria-label": "Bins" }, element("label", {}, "Bins of ", this.over), this.chart, element("p", { class: "hint" }, words), this.numbers);
    this.numbers.addEventListener("toggle", () => this.#write());
    new ResizeObserver(() => this.#draw()).observe(this.chart);
    onTheme(() => this.#draw());
  }

  /** @param {Answer} answer @param {Kind[]} classes @param {string} title of the column */
  show(answer, classes, title) {
    this.answer = answer;
    this.title = title;
    /** Classes of the landings, by their places in counts. */
    this.classes = classes.map((kind, place) => ({ ...kind, place })).filter(({ place }) => answer.all.classes[place].landings > 0);
    this.#draw();
    this.#write();
  }

  #draw() {
    const { answer, classes, title } = this;
    const { clientWidth, clientHeight } = this.chart;
    if (!answer || !classes || !title || clientWidth < 80) return;
    const ratio = window.devicePixelRatio;
    [this.canvas.width, this.canvas.height] = [clientWidth * ratio, clientHeight * ratio];
    const { bins } = answer;
    if (bins.length === 0) return;
    const context = /** @type {CanvasRenderingContext2D} */ (this.canvas.getContext("2d"));
    context.scale(ratio, ratio);
    const room = scaled(ROOM);
    const height = 0.5 * (clientHeight - room.top - room.between - room.bottom);
    const area = { left: room.left, top: room.top, width: clientWidth - room.left - room.right, height };
    const ends = { low: bins[0].from, high: bins[bins.length - 1].to };
    const most = bins.reduce((greatest, { all }) => Math.max(greatest, all.landings), 1);
    this.#bars(frame(context, area, [ends, { low: 0, high: 1.04 * most }], ["", "landings"]), context, classes);
    const below = { ...area, top: area.top + height + room.between };
    this.#probabilities(frame(context, below, [ends, { low: 0, high: 100 }], [title, "probability, %"]), context, classes);
  }

  /**
   * @param {ReturnType<typeof frame>} at
   * @param {CanvasRenderingContext2D} context
   * @param {(Kind & { place: number })[]} classes
   */
  #bars({ x, y }, context, classes) {
    for (const { from, to, all, within } of this.answer?.bins ?? []) {
      let below = 0;
      for (const { class: of, place } of classes) {
        const { landings } = within.classes[place];
        context.fillStyle = classColour(of);
        context.fillRect(x(from) + 1, y(below + landings), x(to) - x(from) - 2, y(below) - y(below + landings));
        below += landings;
      }
      context.strokeStyle = colours().text;
      context.strokeRect(x(from), y(all.landings), x(to) - x(from), y(0) - y(all.landings));
    }
  }

  /**
   * @param {ReturnType<typeof frame>} at
   * @param {CanvasRenderingContext2D} context
   * @param {(Kind & { place: number })[]} classes
   */
  #probabilities({ x, y }, context, classes) {
    for (const { from, to, within } of this.answer?.bins ?? []) {
      for (const [index, { class: of, place }] of classes.entries()) {
        const { probability, low_95, high_95 } = within.classes[place];
        if (probability === null) continue;
        const across = x(from + (to - from) * (0.5 + SPREAD * ((index + 0.5) / classes.length - 0.5)));
        context.strokeStyle = context.fillStyle = classColour(of);
        context.lineWidth = 1.6;
        context.beginPath();
        context.moveTo(across, y(100 * low_95));
        context.lineTo(across, y(100 * high_95));
        context.stroke();
        context.beginPath();
        // Shape tells stable landings from others too.
        if (of === "stable") context.arc(across, y(100 * probability), 3.2, 0, 2 * Math.PI);
        else context.rect(across - 2.8, y(100 * probability) - 2.8, 5.6, 5.6);
        context.fill();
      }
    }
  }

  #write() {
    const { answer, classes, title } = this;
    if (!this.numbers.open || !answer || !classes || !title) return;
    const heads = [title, "all", "selected", ...classes.map(({ word }) => `${word}, with 95 % interval`)];
    const head = element("tr", {}, ...heads.map((text) => {
      const cell = element("th", { scope: "col" });
      cell.append(subscripted(text));
      return cell;
    }));
    const rows = answer.bins.map(({ from, to, all, within }) => {
      const cells = classes.map(({ place }) => {
        const counted = within.classes[place];
        return counted.probability === null ? "–" : `${label(100 * counted.probability, 3)} % (${interval(counted)})`;
      });
      const texts = [String(all.landings), String(within.landings), ...cells];
      return element("tr", {}, element("th", { scope: "row" }, `${label(from)} to ${label(to)}`), ...texts.map((text) => element("td", {}, text)));
    });
    this.table.replaceChildren(element("thead", {}, head), element("tbody", {}, ...rows));
  }
}
