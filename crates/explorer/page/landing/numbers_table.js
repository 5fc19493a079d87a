import { element } from "../look/elements.js";

/** All that a landing came to, number by number, as `touchdown land --json` prints it. */
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
    const results = this.landings.map(({ report }) => report.result);
    const rows = Object.keys(results[0]).map((name) => {
      const cells = results.map((result) => element("td", {}, String(result[name] ?? "")));
      const row = element("tr", {}, element("th", { scope: "row" }, name), ...cells);
      row.dataset.name = name;
      return row;
    });
    this.body.replaceChildren(...rows);
  }
}
