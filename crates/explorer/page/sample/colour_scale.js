import { element } from "../look/elements.js";
import { label, subscripted } from "../look/words.js";

/** @typedef {import("./scatter.js").Quantity} Quantity */

/** Colours of a quantity from its least to its greatest value, with what they mean. */
export class ColourScale {
  /** @param {Quantity} quantity @param {string[]} ramp */
  constructor({ title, values }, ramp) {
    this.values = values;
    this.ramp = ramp;
    const numbers = values.filter((value) => typeof value === "number");
    this.low = numbers.reduce((a, b) => Math.min(a, b), Infinity);
    this.high = numbers.reduce((a, b) => Math.max(a, b), -Infinity);
    const steps = ramp.map((colour) => {
      const step = element("i");
      step.style.background = colour;
      return step;
    });
    this.root = element("div", { class: "colour-scale" }, subscripted(`${title}: `), label(this.low, 4), element("span", {}, ...steps), label(this.high, 4));
  }

  /** None where there is no number. @param {number} landing */
  colour(landing) {
    const value = this.values[landing];
    if (typeof value !== "number") return undefined;
    const share = (value - this.low) / (this.high - this.low || 1);
    return this.ramp[Math.min(Math.floor(share * this.ramp.length), this.ramp.length - 1)];
  }
}
