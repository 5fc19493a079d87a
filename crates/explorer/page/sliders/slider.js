import { element } from "../look/elements.js";
import { label, subscripted } from "../look/words.js";

/** @typedef {import("../engine/types.js").Parameter} Parameter */

let count = 0;

/** A number of the input: slider, field, unit, the words of a complaint, and a button that gives back what the source has. */
export class NumberSlider {
  /**
   * @param {Parameter} parameter
   * @param {(name: string, value: number | string | undefined, isMoving: boolean) => void} onChange
   */
  constructor(parameter, onChange) {
    this.onChange = onChange;
    this.parameter = parameter;
    const id = `number-${(count += 1)}`;
    const title = element("label", { for: id });
    title.append(subscripted(parameter.title));
    this.unit = element("span", { class: "unit" });
    this.back = element("button", { type: "button", class: "back", title: "Give back the number of the input", "aria-label": `Give back ${parameter.title} of the input` }, "↺");
    this.complaint = element("p", { class: "complaint", id: `${id}-complaint`, role: "alert" });
    this.field = parameter.words.length
      ? element("select", { id }, ...parameter.words.map((word) => element("option", {}, word)))
      : element("input", { id, type: "text", inputmode: "decimal", autocomplete: "off", "aria-describedby": `${id}-complaint` });
    this.range = element("input", { type: "range", "aria-label": parameter.title, "aria-describedby": `${id}-complaint` });
    this.root = element("div", { class: "number" }, title, this.field, this.unit, this.back, this.range, this.complaint);
    this.root.dataset.name = parameter.name;
    this.#listen();
    this.isMoving = false;
  }

  #listen() {
    this.range.addEventListener("input", () => {
      this.isMoving = true;
      this.#give(Number(this.range.value), true);
    });
    this.range.addEventListener("change", () => {
      this.isMoving = false;
      this.#give(Number(this.range.value), false);
    });
    this.field.addEventListener("change", () => {
      const text = this.field.value.trim().replace("−", "-");
      if (this.parameter.words.length) this.#give(text, false);
      else if (text === "") this.onChange(this.name, undefined, false);
      // What is no number is refused by the engine, as all that it does not allow.
      else this.#give(Number.isFinite(Number(text)) ? Number(text) : text, false);
    });
    this.back.addEventListener("click", () => this.onChange(this.name, undefined, false));
  }

  /** @param {number | string} value @param {boolean} isMoving */
  #give(value, isMoving) {
    if (typeof value === "number") this.field.value = label(value, 12).replace("−", "-");
    this.onChange(this.name, value, isMoving);
  }

  /** The name of the number in the units that are shown. */
  get name() {
    return this.isSi && this.parameter.si ? this.parameter.si.name : this.parameter.name;
  }

  /**
   * Shows what the engine says of the number.
   * @param {Parameter} parameter
   * @param {"US" | "SI"} units
   * @param {Record<string, number | string>} given what was changed from the source, by name
   * @param {boolean} isRefused whether the engine refused that, so that `parameter` is of before
   */
  show(parameter, units, given, isRefused) {
    this.parameter = parameter;
    this.isSi = units === "SI" && parameter.si !== null;
    const { value, unit, slider } = this.isSi && parameter.si ? parameter.si : parameter;
    const isChanged = parameter.name in given || (parameter.si !== null && parameter.si.name in given);
    this.root.classList.toggle("changed", isChanged);
    this.back.disabled = !isChanged;
    this.unit.textContent = unit;
    this.range.hidden = slider === null || parameter.words.length > 0;
    const range = parameter.words.length > 0 ? "" : parameter.allowed?.text;
    const told = [parameter.meaning, range].filter(Boolean).join("; ");
    this.root.title = told ? `${this.name}: ${told}` : this.name;
    // What is being moved or typed is not pulled from under the hand.
    if (this.isMoving) return;
    if (document.activeElement !== this.field || this.field instanceof HTMLSelectElement) {
      this.field.value = String((isRefused ? given[this.name] : undefined) ?? value ?? "");
    }
    if (slider && typeof value === "number") {
      this.range.min = String(Math.min(slider.from, value));
      this.range.max = String(Math.max(slider.to, value));
      this.range.step = String(slider.step);
      this.range.value = String(value);
      if (Number(this.range.value) !== value) {
        this.range.step = "any";
        this.range.value = String(value);
      }
    }
  }

  /** @param {string} words none takes the complaint away */
  complain(words) {
    this.complaint.textContent = words;
    this.field.setAttribute("aria-invalid", String(words !== ""));
    this.root.classList.toggle("wrong", words !== "");
  }
}
