import { element } from "./elements.js";

/** Tabs after the pattern of ARIA: one is shown, arrow keys go between them. */
export class Tabs extends EventTarget {
  /** @param {HTMLElement} list @param {HTMLElement} place of the panels */
  constructor(list, place) {
    super();
    this.list = list;
    this.place = place;
    /** @type {Map<string, { tab: HTMLButtonElement, panel: HTMLElement }>} */
    this.tabs = new Map();
    list.addEventListener("keydown", (event) => this.#step(event));
  }

  /** @param {string} name @param {string} title @param {HTMLElement} panel */
  add(name, title, panel) {
    const tab = element("button", { type: "button", role: "tab", id: `tab-${name}`, "aria-controls": `panel-${name}` }, title);
    panel.id = `panel-${name}`;
    panel.setAttribute("role", "tabpanel");
    panel.setAttribute("aria-labelledby", tab.id);
    tab.addEventListener("click", () => this.choose(name));
    this.tabs.set(name, { tab, panel });
    this.list.append(tab);
    this.place.append(panel);
  }

  /** @param {string} name */
  choose(name) {
    if (!this.tabs.has(name)) return;
    this.chosen = name;
    for (const [other, { tab, panel }] of this.tabs) {
      const is = other === name;
      tab.setAttribute("aria-selected", String(is));
      tab.tabIndex = is ? 0 : -1;
      panel.hidden = !is;
    }
    this.dispatchEvent(new Event("chosen"));
  }

  /** @param {KeyboardEvent} event */
  #step(event) {
    const by = /** @type {Record<string, number>} */ ({ ArrowRight: 1, ArrowLeft: -1 })[event.key];
    if (!by || this.chosen === undefined) return;
    const names = [...this.tabs.keys()];
    const next = names[(names.indexOf(this.chosen) + by + names.length) % names.length];
    this.choose(next);
    this.tabs.get(next)?.tab.focus();
  }
}
