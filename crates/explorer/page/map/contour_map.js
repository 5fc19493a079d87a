import { element } from "../look/elements.js";
import { colours, onTheme } from "../look/theme.js";
import { font, scaled, textScale, writeWords } from "../look/text.js";
import { label, roundValues } from "../look/words.js";
import { crosshair, disc, openTriangle, ring } from "./marks.js";
import { band, bandsOf, joined, pieces, trianglesOf } from "./triangles.js";
import { nearestPoint, viewOf } from "./view.js";

/** @typedef {import("../engine/types.js").MapAnswer} MapAnswer */
/** @typedef {import("../engine/types.js").MapPoint} MapPoint */

const ROOM = { left: 66, right: 78, top: 10, bottom: 46 };
/** Shortest line that carries a label, and least distance between labels, pixels. */
const LABELLED = 70;
const APART = 46;

/** The contour map with its edges, gaps and jumps. A pointer chooses points, and so do arrow keys. */
export class ContourMap {
  /** @param {(point: MapPoint | undefined) => void} onHover @param {(point: MapPoint) => void} onChoose */
  constructor(onHover, onChoose) {
    this.onHover = onHover;
    this.onChoose = onChoose;
    this.canvas = element("canvas", { tabindex: 0, role: "application", "aria-label": "Contour map; arrow keys go from point to point, Enter lands there" });
    this.root = element("div", { class: "contour" }, this.canvas);
    /** Size of the picture, pixels. */
    this.size = [800, 640];
    /** Size and colours that the picture was painted for. */
    this.looks = "";
    this.canvas.addEventListener("pointermove", (event) => this.#hover(event));
    this.canvas.addEventListener("pointerleave", () => onHover(undefined));
    this.canvas.addEventListener("click", (event) => {
      const point = this.#pointAt(event);
      if (point) onChoose(point);
    });
    this.canvas.addEventListener("keydown", (event) => this.#step(event));
    new ResizeObserver(() => this.draw()).observe(this.root);
    onTheme(() => this.draw());
  }

  /** @param {MapAnswer} map */
  set(map) {
    this.map = map;
    this.triangles = trianglesOf(map);
    this.view = viewOf(map);
    this.picture = undefined;
    this.draw();
  }

  /** Marks a point. @param {MapPoint | undefined} point */
  choose(point) {
    this.chosen = point;
    this.draw();
  }

  get area() {
    const [width, height] = this.size;
    const room = scaled(ROOM);
    return { left: room.left, top: room.top, width: width - room.left - room.right, height: height - room.top - room.bottom };
  }

  /** Pixel of a place. @param {number} slow @param {number} fast @returns {[number, number]} */
  pixel(slow, fast) {
    const { left, top, width, height } = this.area;
    const { up, across } = /** @type {ReturnType<typeof viewOf>} */ (this.view).at(slow, fast);
    return [left + across * width, top + (1 - up) * height];
  }

  /** @param {MouseEvent} event */
  #pointAt(event) {
    if (!this.map || !this.view) return undefined;
    const { left, top, width, height } = this.area;
    const box = this.canvas.getBoundingClientRect();
    const [across, up] = [(event.clientX - box.left - left) / width, 1 - (event.clientY - box.top - top) / height];
    if (across < -0.03 || across > 1.03 || up < -0.03 || up > 1.03) return undefined;
    const { slow, fast } = this.view.placeOf(up, across);
    return nearestPoint(this.map, slow, fast);
  }

  /** @param {PointerEvent} event */
  #hover(event) {
    this.onHover(this.#pointAt(event));
  }

  /** Goes to the nearest point in a direction. @param {KeyboardEvent} event */
  #step(event) {
    const { map, view } = this;
    if (!map || !view || map.points.length === 0) return;
    if (event.key === "Enter" && this.chosen) this.onChoose(this.chosen);
    const way = /** @type {Record<string, [number, number]>} */ ({ ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] })[event.key];
    if (!way) return;
    event.preventDefault();
    const from = this.chosen ?? map.points[Math.floor(map.points.length / 2)];
    const here = view.at(from.place[0], from.place[1]);
    let best = from;
    let least = Infinity;
    for (const point of map.points) {
      const there = view.at(point.place[0], point.place[1]);
      const [dx, dy] = [there.across - here.across, there.up - here.up];
      const along = dx * way[0] + dy * way[1];
      const aside = Math.abs(dx * way[1]) + Math.abs(dy * way[0]);
      if (along > 1e-9 && along + 8 * aside < least) [best, least] = [point, along + 8 * aside];
    }
    this.choose(best);
    this.onHover(best);
  }

  draw() {
    const { map } = this;
    const [width, height] = [this.root.clientWidth, this.root.clientHeight];
    if (!map || width < 50 || height < 50) return;
    this.size = [width, height];
    const ratio = window.devicePixelRatio;
    const looks = [width, height, ratio, colours().paper, textScale()].join();
    if (!this.picture || this.looks !== looks) {
      this.looks = looks;
      this.picture = document.createElement("canvas");
      [this.picture.width, this.picture.height] = [width * ratio, height * ratio];
      [this.canvas.width, this.canvas.height] = [width * ratio, height * ratio];
      const context = /** @type {CanvasRenderingContext2D} */ (this.picture.getContext("2d"));
      context.scale(ratio, ratio);
      this.paint(context, map);
    }
    const context = /** @type {CanvasRenderingContext2D} */ (this.canvas.getContext("2d"));
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    context.drawImage(this.picture, 0, 0);
    if (!this.chosen) return;
    context.scale(ratio, ratio);
    const [x, y] = this.pixel(this.chosen.place[0], this.chosen.place[1]);
    crosshair(context, x, y, colours().text, colours().paper);
  }

  /** Paints all but the crosshair. @param {CanvasRenderingContext2D} context @param {MapAnswer} map */
  paint(context, map) {
    const now = colours();
    context.fillStyle = now.paper;
    context.fillRect(0, 0, this.size[0], this.size[1]);
    this.#fill(context, map);
    this.#frame(context, map);
    this.#lines(context, map);
    this.#points(context, map);
    this.#bar(context, map);
  }

  /** @param {CanvasRenderingContext2D} context @param {MapAnswer} map */
  #fill(context, map) {
    const trace = (/** @type {[number, number][]} */ polygon) => {
      for (const [index, [x, y]] of polygon.entries()) {
        if (index === 0) context.moveTo(x, y);
        else context.lineTo(x, y);
      }
      context.closePath();
    };
    if (map.grid) {
      const [{ values: slow }, { values: fast }] = map.axes;
      context.fillStyle = colours().paper === "#ffffff" ? map.colours.jump_cell : "#3a2430";
      for (const [row, column] of map.jump_cells) {
        context.beginPath();
        trace([[0, 0], [0, 1], [1, 1], [1, 0]].map(([r, c]) => this.pixel(slow[row + r], fast[column + c])));
        context.fill();
      }
    }
    for (const { low, high, colour } of bandsOf(map.levels)) {
      // All of a band is one shape, so that no seams show between its parts.
      context.fillStyle = context.strokeStyle = colour;
      context.lineWidth = 0.6;
      context.beginPath();
      for (const polygon of band(this.triangles ?? [], low, high)) trace(polygon.map(([slow, fast]) => this.pixel(slow, fast)));
      context.fill();
      context.stroke();
    }
  }

  /** @param {CanvasRenderingContext2D} context @param {MapAnswer} map */
  #frame(context, map) {
    const { left, top, width, height } = this.area;
    const now = colours();
    context.font = font(12);
    context.fillStyle = now.text;
    context.textAlign = "center";
    context.textBaseline = "top";
    const { slowEnds, fastEnds } = /** @type {ReturnType<typeof viewOf>} */ (this.view);
    for (const value of roundValues(fastEnds.low, fastEnds.high, width / (60 * textScale()))) {
      const [x] = this.pixel(slowEnds.low, value);
      context.fillText(label(value), x, top + height + 9);
      context.globalAlpha = 0.12;
      context.fillRect(x, top, 1, height);
      context.globalAlpha = 1;
    }
    context.textAlign = "right";
    context.textBaseline = "middle";
    for (const value of roundValues(slowEnds.low, slowEnds.high, height / (40 * textScale()))) {
      const [, y] = this.pixel(value, fastEnds.low);
      // The lowest one stands above the first of the other axis.
      context.fillText(label(value), left - 10, Math.min(y, top + height - 5 * textScale()));
      context.globalAlpha = 0.12;
      context.fillRect(left, y, width, 1);
      context.globalAlpha = 1;
    }
    context.strokeStyle = now.text;
    context.lineWidth = 1;
    context.strokeRect(left, top, width, height);
    context.textAlign = "center";
    context.font = font(13);
    writeWords(context, map.axes[1].title, left + 0.5 * width, top + height + 32 * textScale());
    context.save();
    context.translate(14 * textScale(), top + 0.5 * height);
    context.rotate(-Math.PI / 2);
    writeWords(context, map.axes[0].title, 0, 0);
    context.restore();
  }

  /** Lines of equal V_H with their labels, and edges. @param {CanvasRenderingContext2D} context @param {MapAnswer} map */
  #lines(context, map) {
    const now = colours();
    /** @type {[number, number, string][]} */
    const labels = [];
    const { left, top, width, height } = this.area;
    const follow = (/** @type {number[][]} */ places) => {
      context.beginPath();
      for (const [index, [slow, fast]] of places.entries()) {
        const [x, y] = this.pixel(slow, fast);
        if (index === 0) context.moveTo(x, y);
        else context.lineTo(x, y);
      }
      context.stroke();
    };
    context.strokeStyle = "#262626";
    context.lineWidth = 1.2;
    for (const { speed } of map.levels) {
      if (speed === null) continue;
      for (const line of joined(pieces(this.triangles ?? [], speed))) {
        follow(line);
        const places = line.map(([slow, fast]) => this.pixel(slow, fast));
        const length = places.reduce((sum, [x, y], i) => sum + (i ? Math.hypot(x - places[i - 1][0], y - places[i - 1][1]) : 0), 0);
        if (length < LABELLED) continue;
        const middle = places.length >> 1;
        const order = [...places.keys()].sort((a, b) => Math.abs(a - middle) - Math.abs(b - middle));
        const free = order.find((index) => {
          const [x, y] = places[index];
          const isInside = x > left + 18 && x < left + width - 18 && y > top + 10 && y < top + height - 10;
          return isInside && labels.every(([u, v]) => Math.hypot(x - u, y - v) > APART);
        });
        if (free !== undefined) labels.push([...places[free], label(speed)]);
      }
    }
    context.font = font(11);
    for (const [x, y, text] of labels) {
      const half = 0.5 * context.measureText(text).width + 3;
      const tall = 15 * textScale();
      context.fillStyle = "#ffffffd9";
      context.fillRect(x - half, y - 0.5 * tall, 2 * half, tall);
      context.fillStyle = "#262626";
      context.fillText(text, x, y + 0.5);
    }
    context.strokeStyle = now.jump;
    context.lineWidth = 3;
    for (const bar of map.jump_bars) follow(bar);
    for (const edge of map.edges) {
      context.strokeStyle = edge.kind === "end" ? now.stable : edge.kind === "jump" ? now.jump : now.text;
      context.lineWidth = edge.kind === "bands" ? 1.5 : 2;
      context.setLineDash(edge.kind === "bands" ? [4, 3] : []);
      follow(edge.places);
    }
    context.strokeStyle = now.text;
    context.lineWidth = 2;
    context.setLineDash([9, 6]);
    map.bisector.forEach(follow);
    context.setLineDash([]);
  }

  /** @param {CanvasRenderingContext2D} context @param {MapAnswer} map */
  #points(context, map) {
    const now = colours();
    if (map.grid) {
      for (const [slow, fast] of map.lowest) disc(context, ...this.pixel(slow, fast), 4, now.lowest);
      const { width, height } = this.area;
      const room = Math.min(width / map.axes[1].values.length, height / map.axes[0].values.length);
      const half = room > 24 ? 5 : Math.max(Math.min(0.3 * room, 3.5), 1.5);
      for (const { place, to } of map.points) {
        if (to === null) openTriangle(context, ...this.pixel(place[0], place[1]), half, now.stable);
      }
    }
    if (!map.grid && !map.triangles) this.#scattered(context, map);
    for (const { place, to, certainty, patchy_to } of map.points) {
      if (patchy_to !== null) ring(context, ...this.pixel(place[0], place[1]), 3, now.stable);
      const isDoubtful = to === "failure" || to === "undecided";
      if (isDoubtful) disc(context, ...this.pixel(place[0], place[1]), 3.5, now[/** @type {"failure"} */ (to)]);
      if (certainty !== "disputed") continue;
      context.strokeStyle = now.lowest;
      context.lineWidth = 1.5;
      const [x, y] = this.pixel(place[0], place[1]);
      context.strokeRect(x - 4, y - 4, 8, 8);
    }
  }

  /** Points that no surface joins, in the colours of their bands, with V_H where there is room. @param {CanvasRenderingContext2D} context @param {MapAnswer} map */
  #scattered(context, map) {
    const radius = Math.max(2, Math.min(7, 160 / Math.sqrt(map.points.length)));
    const bands = bandsOf(map.levels);
    /** @type {[number, number][]} */
    const written = [];
    const [wide, tall] = [36 * textScale(), 14 * textScale()];
    context.font = font(10);
    context.textAlign = "center";
    context.textBaseline = "middle";
    for (const { place, speed } of map.points) {
      const [x, y] = this.pixel(place[0], place[1]);
      if (speed === null) {
        openTriangle(context, x, y, 0.7 * radius, colours().stable);
        continue;
      }
      disc(context, x, y, radius, bands.find(({ high }) => speed < high)?.colour ?? colours().text);
      // Below the point, and above it at the lower edge, where the axis has its numbers.
      const away = radius + 0.5 * tall;
      const below = y + away > this.area.top + this.area.height ? y - away : y + away;
      const isFree = map.points.every((other) => {
        const [u, v] = this.pixel(other.place[0], other.place[1]);
        return other.place === place || Math.abs(u - x) > 0.5 * wide || Math.abs(v - below) > 0.5 * tall + radius;
      });
      if (!isFree || written.some(([u, v]) => Math.abs(u - x) < wide && Math.abs(v - below) < tall)) continue;
      written.push([x, below]);
      context.fillStyle = colours().text;
      context.fillText(label(speed, 3), x, below);
    }
  }

  /** The bar of colours. @param {CanvasRenderingContext2D} context @param {MapAnswer} map */
  #bar(context, map) {
    const { left, top, width, height } = this.area;
    const x = left + width + 22;
    const count = map.levels.length;
    const step = Math.min((height - 40) / Math.max(count, 1), 44);
    const bottom = top + 34 + step * count;
    context.textAlign = "left";
    context.fillStyle = colours().text;
    context.font = font(12);
    writeWords(context, `V_H, ${map.speed_unit}`, x, top + 8 * textScale());
    for (const [index, { speed, colour }] of map.levels.entries()) {
      const y = bottom - step * (index + 1);
      context.fillStyle = colour;
      context.fillRect(x, y, 18, step);
      context.strokeStyle = colours().text;
      context.lineWidth = 1;
      context.strokeRect(x, y, 18, step);
      context.fillStyle = colours().text;
      if (speed !== null) context.fillText(label(speed), x + 24, y);
    }
  }
}
