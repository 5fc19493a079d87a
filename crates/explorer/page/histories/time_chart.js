import uPlot from "../vendor/uplot.js";
import { element } from "../look/elements.js";
import { colours, curveColour } from "../look/theme.js";
import { font, textScale } from "../look/text.js";
import { label, subscripted } from "../look/words.js";

/** @typedef {{ name: string, values: (number | null)[], colour?: string, dash?: number[], width?: number,
 *   readings?: number[] }} Curve what is read at the cursor is its value unless it has readings; a curve without a name is only there for bands */
/**
 * What a chart shows over time. `bands` are pairs of numbers of curves between which is filled.
 * @typedef {{ title: string, unit: string, times: number[], curves: Curve[], bands?: { series: [number, number], fill: string }[],
 *   events: { time_s: number, kind: string }[] }} Content
 */

const HEIGHT = 150;

/** Curves over time, with a cursor at the time that is shown; a pointer on it goes to another time. */
export class TimeChart {
  /** @param {(time: number) => void} onTime */
  constructor(onTime) {
    this.onTime = onTime;
    this.caption = element("figcaption");
    this.place = element("div", { class: "plot" });
    this.root = element("figure", { class: "chart" }, this.caption, this.place);
    this.cursor = element("div", { class: "time-cursor" });
    this.time = 0;
    /** What the plot was built for. */
    this.built = "";
    /** @type {HTMLElement[]} */
    this.readings = [];
    /** @type {Content | undefined} */
    this.offered = undefined;
    /** What is shown. @type {Content | undefined} */
    this.content = undefined;
    this.isSeen = false;
    /** @type {() => void} */
    this.onSeen = () => {};
    new ResizeObserver(() => this.#resize()).observe(this.place);
    new IntersectionObserver(([entry]) => {
      this.isSeen = entry.isIntersecting;
      if (this.isSeen) this.onSeen();
    }).observe(this.root);
  }

  /** Takes what is to be shown, when there is time for it. @param {Content} content */
  offer(content) {
    this.offered = content;
  }

  /** Whether something is to be drawn that can be seen. */
  get isWaiting() {
    return this.offered !== undefined && this.isSeen;
  }

  draw() {
    const content = this.offered;
    if (!content) return;
    this.offered = undefined;
    const looks = content.curves.map(({ name, colour, dash }) => [name, colour, dash]);
    const built = JSON.stringify([content.title, content.unit, looks, colours().paper]);
    this.content = content;
    if (built !== this.built || !this.plot) {
      this.built = built;
      this.#build(content);
    } else {
      this.plot.setData(data(content));
    }
  }

  /** @param {Content} content */
  #build(content) {
    this.plot?.destroy();
    const { text, grid } = colours();
    const scale = textScale();
    const axis = { stroke: text, grid: { stroke: grid, width: 1 }, ticks: { stroke: grid, width: 1 }, font: font(11) };
    const written = (/** @type {uPlot} */ _, /** @type {number[]} */ values) => values.map((value) => label(value, 4));
    const options = /** @type {uPlot.Options} */ ({
      width: Math.max(this.place.clientWidth, 120),
      height: HEIGHT,
      legend: { show: false },
      cursor: { y: false, points: { show: false }, drag: { setScale: false, x: false, y: false } },
      scales: { x: { time: false }, y: { range: (_, low, high) => padded(low, high) } },
      axes: [
        { ...axis, size: 26 * scale, values: written, space: 44 * scale },
        { ...axis, size: 52 * scale, values: written, space: 26 * scale },
      ],
      series: [
        {},
        ...content.curves.map(({ colour, dash, width }, index) => ({
          stroke: colour ?? curveColour(index),
          width: width ?? 1.6,
          dash,
          points: { show: false },
          spanGaps: false,
        })),
      ],
      bands: content.bands,
      hooks: {
        ready: [(plot) => plot.over.append(this.cursor)],
        drawClear: [(plot) => this.#drawEvents(plot)],
        draw: [() => this.at(this.time)],
      },
    });
    this.plot = new uPlot(options, data(content), this.place);
    this.#listen(this.plot.over);
    this.#writeCaption(content);
  }

  /** @param {HTMLElement} over */
  #listen(over) {
    const go = (/** @type {PointerEvent} */ event) => {
      if (!this.plot || !(event.buttons & 1)) return;
      const { left } = over.getBoundingClientRect();
      this.onTime(this.plot.posToVal(event.clientX - left, "x"));
    };
    over.addEventListener("pointerdown", (event) => {
      over.setPointerCapture(event.pointerId);
      go(event);
    });
    over.addEventListener("pointermove", go);
  }

  /** @param {Content} content */
  #writeCaption({ title, unit, curves }) {
    this.readings = [];
    const names = curves.map(({ name, colour, dash }, index) => {
      const key = element("i", { class: dash ? "key dashed" : "key" });
      key.style.color = colour ?? curveColour(index);
      const reading = element("output");
      this.readings.push(reading);
      return name ? element("span", {}, key, subscripted(`${name} `), reading) : "";
    });
    this.caption.replaceChildren(element("strong", {}, unit ? `${title}, ${unit}` : title), ...names);
  }

  /** @param {uPlot} plot */
  #drawEvents(plot) {
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.lineWidth = devicePixelRatio;
    for (const { time_s, kind } of this.content?.events ?? []) {
      const x = plot.valToPos(time_s, "x", true);
      ctx.strokeStyle = kind === "verdict" || kind === "failure" || kind === "bottomed" ? colours().jump : colours().paleText;
      ctx.globalAlpha = 0.45;
      ctx.setLineDash(kind === "block-contact" ? [2, 3] : [4, 3]);
      ctx.beginPath();
      ctx.moveTo(x, bbox.top);
      ctx.lineTo(x, bbox.top + bbox.height);
      ctx.stroke();
    }
    ctx.restore();
  }

  #resize() {
    const width = this.place.clientWidth;
    if (!this.plot || width < 20 || Math.abs(width - this.plot.width) < 1) return;
    this.plot.setSize({ width, height: HEIGHT });
  }

  /** Moves the cursor. @param {number} time s */
  at(time) {
    this.time = time;
    if (!this.plot || !this.content) return;
    this.cursor.style.transform = `translateX(${this.plot.valToPos(time, "x")}px)`;
    const { times, curves } = this.content;
    const index = nearest(times, time);
    for (const [number, { values, readings }] of curves.entries()) this.readings[number].textContent = reading((readings ?? values)[index]);
  }
}

/** A value to four digits; what is next to nothing is nothing. @param {number | null} value */
const reading = (value) => label(value !== null && Math.abs(value) < 1e-6 ? 0 : value, 4);

/** @param {Content} content @returns {uPlot.AlignedData} */
const data = ({ times, curves }) => /** @type {uPlot.AlignedData} */ ([times, ...curves.map(({ values }) => values)]);

/** @param {number | null} low @param {number | null} high @returns {[number, number]} */
function padded(low, high) {
  if (low === null || high === null) return [0, 1];
  const margin = Math.max(0.06 * (high - low), 1e-6 * Math.abs(low), 1e-9);
  return [low - margin, high + margin];
}

/** @param {number[]} values rising @param {number} value */
function nearest(values, value) {
  let [low, high] = [0, values.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (values[middle] <= value) low = middle;
    else high = middle;
  }
  return value - values[low] < values[high] - value ? low : high;
}
