import { element } from "../look/elements.js";
import { classColour, colours, onTheme, regionColour } from "../look/theme.js";
import { font, scaled, textScale, writeWords } from "../look/text.js";
import { label, roundValues } from "../look/words.js";
import { disc, openTriangle } from "./marks.js";

/** @typedef {import("../engine/types.js").MapPoint} MapPoint */

/**
 * V_H over one axis. `breaks` tells where the line must not join a point to the next.
 * @typedef {{ x: number, point: MapPoint, breaks: boolean }} Place
 * `isTurned` tells that the axis runs to the left, as on the map.
 * @typedef {{ title: string, note: string, unit: string, places: Place[], isTurned: boolean, chosen: number | null }} Content
 */

const ROOM = { left: 52, right: 18, top: 32, bottom: 40 };

/** V_H over one axis: a section through a map, or a profile with its bands. */
export class BoundaryChart {
  /** @param {(point: MapPoint | undefined) => void} onHover @param {(point: MapPoint) => void} onChoose */
  constructor(onHover, onChoose) {
    this.canvas = element("canvas", { tabindex: 0, role: "application" });
    this.root = element("div", { class: "boundary" }, this.canvas);
    this.canvas.addEventListener("pointermove", (event) => onHover(this.#at(event)?.point));
    this.canvas.addEventListener("pointerleave", () => onHover(undefined));
    this.canvas.addEventListener("click", (event) => {
      const place = this.#at(event);
      if (place) onChoose(place.point);
    });
    this.canvas.addEventListener("keydown", (event) => {
      const by = /** @type {Record<string, number>} */ ({ ArrowLeft: -1, ArrowRight: 1 })[event.key];
      const { content } = this;
      if (!by || !content?.places.length) return;
      event.preventDefault();
      const now = content.places.findIndex(({ x }) => x === content.chosen);
      const next = content.places[Math.min(Math.max(now + (content.isTurned ? -by : by), 0), content.places.length - 1)];
      onHover(next.point);
      onChoose(next.point);
    });
    new ResizeObserver(() => this.draw()).observe(this.root);
    onTheme(() => this.draw());
  }

  /** @param {Content} content */
  set(content) {
    this.content = content;
    this.canvas.setAttribute("aria-label", `V_H over ${content.title}; arrow keys go from point to point`);
    this.draw();
  }

  get ends() {
    const places = this.content?.places ?? [];
    const xs = places.map(({ x }) => x);
    const speeds = places.flatMap(({ point }) => [point.speed, ...(point.bands ?? []).flatMap((band) => [band.from, band.to])]);
    const known = speeds.filter((speed) => speed !== null);
    const [low, high] = known.length ? [Math.min(...known), Math.max(...known)] : [0, 1];
    const margin = 0.08 * (high - low || 1);
    return { left: Math.min(...xs), right: Math.max(...xs), low: Math.max(low - margin, 0), high: high + margin };
  }

  get area() {
    const { clientWidth, clientHeight } = this.root;
    const room = scaled(ROOM);
    return { left: room.left, top: room.top, width: clientWidth - room.left - room.right, height: clientHeight - room.top - room.bottom };
  }

  /** @param {MouseEvent} event */
  #at(event) {
    const { area, ends, content } = this;
    if (!content) return undefined;
    const share = (event.clientX - this.canvas.getBoundingClientRect().left - area.left) / area.width;
    const x = ends.left + (content.isTurned ? 1 - share : share) * (ends.right - ends.left);
    return content.places.reduce((best, place) => (Math.abs(place.x - x) < Math.abs(best.x - x) ? place : best), content.places[0]);
  }

  draw() {
    const { content, area, ends } = this;
    const { clientWidth, clientHeight } = this.root;
    if (!content?.places.length || clientWidth < 80) return;
    const ratio = window.devicePixelRatio;
    [this.canvas.width, this.canvas.height] = [clientWidth * ratio, clientHeight * ratio];
    const context = /** @type {CanvasRenderingContext2D} */ (this.canvas.getContext("2d"));
    context.scale(ratio, ratio);
    const span = ends.right - ends.left || 1;
    const px = (/** @type {number} */ x) => {
      const share = (x - ends.left) / span;
      return area.left + (content.isTurned ? 1 - share : share) * area.width;
    };
    const py = (/** @type {number} */ speed) => area.top + (1 - (speed - ends.low) / (ends.high - ends.low)) * area.height;
    this.#bands(context, px, py);
    this.#frame(context, px, py);
    this.#line(context, px, py);
  }

  /** @param {CanvasRenderingContext2D} context @param {(x: number) => number} px @param {(speed: number) => number} py */
  #bands(context, px, py) {
    const places = this.content?.places ?? [];
    for (const [index, { x, point }] of places.entries()) {
      const left = index === 0 ? x : 0.5 * (x + places[index - 1].x);
      const right = index === places.length - 1 ? x : 0.5 * (x + places[index + 1].x);
      for (const band of point.bands ?? []) {
        if (band.class === "stable") continue;
        context.fillStyle = regionColour(band.class);
        const [from, to] = [px(left), px(right)].sort((a, b) => a - b);
        context.fillRect(from, py(band.to), to - from + 0.5, py(band.from) - py(band.to));
      }
    }
    this.#word(context, px, py);
  }

  /** Says what the landings of the widest band do. @param {CanvasRenderingContext2D} context @param {(x: number) => number} px @param {(speed: number) => number} py */
  #word(context, px, py) {
    const all = (this.content?.places ?? []).flatMap(({ x, point }) => (point.bands ?? []).map((band) => ({ x, ...band })));
    const others = all.filter((band) => band.class !== "stable");
    if (!others.length) return;
    const widest = others.reduce((best, band) => (band.to - band.from > best.to - best.from ? band : best), others[0]);
    context.fillStyle = classColour(widest.class);
    context.font = font(16);
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillText(widest.word, px(widest.x), py(0.5 * (widest.from + widest.to)));
  }

  /** @param {CanvasRenderingContext2D} context @param {(x: number) => number} px @param {(speed: number) => number} py */
  #frame(context, px, py) {
    const { area, ends } = this;
    const content = /** @type {Content} */ (this.content);
    const now = colours();
    context.font = font(11);
    context.fillStyle = now.text;
    context.strokeStyle = now.grid;
    context.textAlign = "center";
    context.textBaseline = "top";
    for (const x of roundValues(ends.left, ends.right, area.width / (60 * textScale()))) {
      context.strokeRect(px(x), area.top, 0, area.height);
      context.fillText(label(x), px(x), area.top + area.height + 5);
    }
    context.textAlign = "right";
    context.textBaseline = "middle";
    for (const speed of roundValues(ends.low, ends.high, area.height / (26 * textScale()))) {
      context.strokeRect(area.left, py(speed), area.width, 0);
      context.fillText(label(speed), area.left - 5, py(speed));
    }
    context.textAlign = "center";
    context.font = font(12);
    writeWords(context, content.title, area.left + 0.5 * area.width, area.top + area.height + 28 * textScale());
    context.textAlign = "left";
    writeWords(context, `V_H, ${content.unit}`, 4, 12 * textScale());
    context.fillStyle = now.paleText;
    context.textAlign = "right";
    writeWords(context, content.note, area.left + area.width, 12 * textScale());
    if (content.chosen !== null) {
      context.fillStyle = now.jump;
      context.fillRect(px(content.chosen) - 1, area.top, 2, area.height);
    }
  }

  /** @param {CanvasRenderingContext2D} context @param {(x: number) => number} px @param {(speed: number) => number} py */
  #line(context, px, py) {
    const places = this.content?.places ?? [];
    const now = colours();
    context.strokeStyle = now.paleText;
    context.lineWidth = 2;
    context.beginPath();
    let isOpen = true;
    for (const { x, point, breaks } of places) {
      if (point.speed === null) {
        isOpen = true;
        continue;
      }
      if (isOpen) context.moveTo(px(x), py(point.speed));
      else context.lineTo(px(x), py(point.speed));
      isOpen = breaks;
    }
    context.stroke();
    const radius = places.length > 60 ? 2.5 : 4;
    for (const { x, point } of places) {
      if (point.speed === null) openTriangle(context, px(x), this.area.top + 5, radius, now.stable);
      else disc(context, px(x), py(point.speed), radius, point.to ? classColour(point.to) : now.text);
    }
  }
}
