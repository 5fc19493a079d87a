import * as engine from "../engine/engine.js";
import { element } from "../look/elements.js";
import { classColour, colours, onTheme, regionColour } from "../look/theme.js";
import { STILL } from "../landing/sharpness.js";
import { font, scaled, textScale } from "../look/text.js";
import { label, roundValues, subscripted } from "../look/words.js";

/** @typedef {import("../engine/types.js").StripLanding} StripLanding */
/** @typedef {import("../engine/types.js").Band} Band */
/** @typedef {import("../engine/types.js").Transition} Transition */

/** Where the bands lie, pixels at the usual size of text. */
const PLACE = { top: 20, height: 26 };
/** Landings of one request; few while others wait. */
const MOST = 16;
/** Distance of the stripes of a patchy stretch, pixels. */
const STRIPES_APART = 5;
const FPS_A_MPS = 1 / 0.3048;

/** How landings end over the whole range of V_H under the present conditions, with a handle for V_H. */
export class OutcomeStrip {
  /** @param {import("../present/present.js").Present} present @param {import("../engine/types.js").Source[]} sources */
  constructor(present, sources) {
    this.present = present;
    this.sources = sources;
    this.canvas = element("canvas", { "aria-hidden": "true" });
    this.handle = element("input", { type: "range", "aria-label": "Horizontal velocity V_H", step: 0.01 });
    this.words = element("p", { class: "strip-words", role: "status" });
    const title = element("h2");
    title.append(subscripted("How landings end over V_H"));
    this.certain = element("button", { type: "button" }, "Find the bands exactly");
    this.certain.title = "Searches all transitions and tests how certain they are; this takes hundreds of landings";
    this.root = element("section", { class: "strip" },
      element("div", { class: "strip-head" }, title, this.certain),
      element("div", { class: "strip-line" }, this.canvas, this.handle), this.words);
    /** @type {StripLanding[]} */
    this.known = [];
    /** @type {Band[]} */
    this.bands = [];
    this.exact = false;
    /** The first transition of an exact search. @type {Transition | null} */
    this.first = null;
    this.round = new AbortController();
    this.conditions = "";
    /** What was drawn last. */
    this.shown = "";
    this.speed = 0;
    this.handle.addEventListener("input", () => this.#move(true));
    this.handle.addEventListener("change", () => this.#move(false));
    this.certain.addEventListener("click", () => this.#findBands());
    new ResizeObserver(() => this.draw()).observe(this.canvas);
    onTheme(() => this.draw());
  }

  get range() {
    const search = this.sources.find(({ name }) => name === this.present.source)?.search ?? { from_fps: 0, to_fps: 25 };
    return { from: search.from_fps, to: search.to_fps };
  }

  /** V_H as the page's units have it, from ft/s. @param {number} fps */
  inUnits(fps) {
    return this.present.units === "SI" ? fps / FPS_A_MPS : fps;
  }

  get unit() {
    return this.present.units === "SI" ? "m/s" : "ft/s";
  }

  /** @param {boolean} isMoving */
  #move(isMoving) {
    const speed = Number(this.handle.value);
    delete this.present.values.horizontal_velocity_mps;
    this.speed = speed;
    this.draw();
    this.present.set("horizontal_velocity_fps", Number(speed.toFixed(4)), isMoving);
  }

  /** Follows the present conditions, with V_H in ft/s. @param {number} speed */
  follow(speed) {
    this.speed = speed;
    const { from, to } = this.range;
    this.handle.min = String(from);
    this.handle.max = String(Math.max(to, speed));
    if (document.activeElement !== this.handle || !this.present.isMoving) this.handle.value = String(speed);
    this.handle.setAttribute("aria-valuetext", `${label(this.inUnits(speed), 5)} ${this.unit}`);
    const { touchdown } = this.present;
    const { horizontal_velocity_fps, horizontal_velocity_mps, ...values } = touchdown.values ?? {};
    const conditions = JSON.stringify({ ...touchdown, values });
    if (conditions !== this.conditions) {
      this.conditions = conditions;
      this.#restart();
    }
    const shown = [speed, from, this.handle.max, this.unit, this.isStale].join();
    if (shown !== this.shown) this.draw();
    this.shown = shown;
  }

  /** Pales, as what it shows is not of the present numbers. */
  refuse() {
    this.round.abort();
    this.conditions = "";
    this.isStale = true;
    this.draw();
  }

  #restart() {
    this.round.abort();
    this.round = new AbortController();
    this.known = [];
    this.exact = false;
    this.first = null;
    this.isStale = true;
    const { signal } = this.round;
    setTimeout(() => this.#fill(signal), STILL);
  }

  /** Asks for landings until the strip is done. @param {AbortSignal} signal */
  async #fill(signal) {
    const { from, to } = this.range;
    try {
      while (!signal.aborted) {
        const { touchdown } = this.present;
        const request = { touchdown, from_fps: from, to_fps: to, known: this.known, most: MOST, resolution_fps: (to - from) / 1000 };
        const answer = await engine.strip(request, signal);
        if (signal.aborted) return;
        this.known = [...this.known, ...answer.landings].sort((a, b) => a.speed_fps - b.speed_fps);
        this.bands = answer.bands;
        this.isStale = false;
        this.draw();
        if (answer.is_done) break;
      }
      this.root.dispatchEvent(new Event("done"));
    } catch (error) {
      // What is wrong with the conditions is told by the landing.
      if (!(error instanceof engine.EngineError) && !signal.aborted) throw error;
    }
  }

  async #findBands() {
    const { signal } = this.round;
    const { from, to } = this.range;
    this.certain.disabled = true;
    this.words.textContent = "searching …";
    try {
      const answer = await engine.bands({ touchdown: this.present.touchdown, from_fps: from, to_fps: to }, signal);
      this.bands = answer.bands;
      this.first = answer.first_transition;
      this.exact = true;
      this.draw();
    } catch (error) {
      if (!signal.aborted) this.words.textContent = error instanceof Error ? error.message : String(error);
    } finally {
      this.certain.disabled = false;
    }
  }

  draw() {
    const width = this.canvas.clientWidth;
    if (width < 20) return;
    const ratio = window.devicePixelRatio;
    this.canvas.width = width * ratio;
    this.canvas.height = this.canvas.clientHeight * ratio;
    const context = /** @type {CanvasRenderingContext2D} */ (this.canvas.getContext("2d"));
    context.scale(ratio, ratio);
    const { from } = this.range;
    const to = Number(this.handle.max) || this.range.to;
    const at = (/** @type {number} */ speed) => 8 + ((width - 16) * (speed - from)) / (to - from);
    const now = colours();
    const bar = scaled(PLACE);
    context.globalAlpha = this.isStale ? 0.45 : 1;
    context.font = font(12);
    for (const band of this.bands) {
      const [left, right] = [at(band.from_fps), at(band.to_fps)];
      context.fillStyle = band.class === "stable" ? `${classColour("stable")}33` : regionColour(band.class);
      context.fillRect(left, bar.top, right - left, bar.height);
      context.fillStyle = classColour(band.class);
      context.fillRect(left, bar.top + bar.height - 4, right - left, 4);
      context.textAlign = "center";
      if (context.measureText(band.word).width < right - left - 8) context.fillText(band.word, 0.5 * (left + right), bar.top + 0.62 * bar.height);
    }
    if (this.first?.patchy) {
      context.fillStyle = classColour("stable");
      const end = at(this.first.patchy.to_fps);
      for (let x = at(this.first.speed_fps); x <= end; x += STRIPES_APART) context.fillRect(x, bar.top, 1.5, bar.height - 4);
    }
    context.strokeStyle = now.paleText;
    for (const { speed_fps } of this.known) {
      context.beginPath();
      context.moveTo(at(speed_fps), bar.top - 4);
      context.lineTo(at(speed_fps), bar.top);
      context.stroke();
    }
    context.globalAlpha = 1;
    context.strokeStyle = now.text;
    context.strokeRect(8, bar.top, width - 16, bar.height);
    context.fillStyle = now.text;
    const scale = this.present.units === "SI" ? FPS_A_MPS : 1;
    for (const value of roundValues(from / scale, to / scale, width / (70 * textScale()))) {
      const x = at(value * scale);
      context.fillRect(x, bar.top + bar.height, 1, 5);
      context.fillText(label(value), x, bar.top + bar.height + 5 + 13 * textScale());
    }
    const x = at(this.speed);
    context.fillStyle = now.jump;
    context.fillRect(x - 1.25, bar.top - 8, 2.5, bar.height + 14);
    context.beginPath();
    context.moveTo(x - 7, 4);
    context.lineTo(x + 7, 4);
    context.lineTo(x, 15);
    context.fill();
    this.#write();
  }

  #write() {
    if (!this.bands.length) return;
    const number = (/** @type {number} */ fps) => label(this.inUnits(fps), this.exact ? 7 : 4);
    const words = this.bands.map((band) => {
      const certain = this.exact && band.certainty ? ` (${band.certainty})` : "";
      return `${band.word} ${number(band.from_fps)} to ${number(band.to_fps)}${certain}`;
    });
    this.words.textContent = `${words.join(" · ")} ${this.unit}${this.#evidence(number)}`;
  }

  /** What is known of the first transition and of what lies below it. @param {(fps: number) => string} number */
  #evidence(number) {
    if (!this.first) return "";
    const { patchy, speed_fps, stable_landings_below } = this.first;
    const below = `; ${stable_landings_below} landings below ${number(speed_fps)} are stable`;
    if (!patchy) return below;
    return `${below}; patchy up to ${number(patchy.to_fps)}: ${patchy.not_stable} of ${patchy.landings} landings are not stable there`;
  }
}
