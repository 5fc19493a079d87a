import { element } from "../look/elements.js";
import { inUnit, label } from "../look/words.js";

/** All that a landing came to, number by number, by the names of `touchdown land --json`; the title of a number has all of its digits. */
export class NumbersTable {
  constructor() {
    this.body = element("tbody");
    this.root = element("details", { class: "numbers" }, element("summary", {}, "All numbers of the landing"), element("table", {}, this.body));
    this.root.addEventListener("toggle", () => this.#write());
  }

  /** @param {import("../engine/types.js").Landing[]} landings */
  show(landings) {
    this.landings = landings;
    this.#write();
  }

  #write() {
    if (!this.root.open || !this.landings) return;
    const rows = Object.keys(this.landings[0].report.result).map((name) => {
      const cells = (this.landings ?? []).map(({ report: { result }, result_units: units }) => {
        const value = result[name] ?? "";
        const text = typeof value === "number" ? `${label(value)}${inUnit(units?.[name] ?? "")}` : value;
        return element("td", { title: value }, text);
      });
      const row = element("tr", {}, element("th", { scope: "row" }, name), ...cells);
      row.dataset.name = name;
      return row;
    });
    this.body.replaceChildren(...rows);
  }
}
