import * as engine from "../engine/engine.js";
import { button, element } from "../look/elements.js";
import { historiesSvg } from "./histories_svg.js";
import { record } from "./recorder.js";
import { png, save } from "./save.js";
import { surfaceSvg } from "./surface_svg.js";
import { stageSvg } from "./stage_svg.js";
import { SvgContext } from "./svg_context.js";

/** @typedef {import("../landing/replay.js").Replay} Replay */
/** @typedef {import("../map/map_tab.js").MapTab} MapTab */

/** The menu of what can be taken away: files, pictures, the command, a link. */
export class TakeAway {
  /**
   * @param {import("../present/present.js").Present} present
   * @param {Replay} replay the present landing
   * @param {MapTab} map
   * @param {() => string} address that restores what is shown
   */
  constructor(present, replay, map, address) {
    this.present = present;
    this.replay = replay;
    this.note = element("p", { class: "take-note", role: "status" });
    this.command = element("textarea", { readonly: true, rows: 3, "aria-label": "Command that repeats the landing", hidden: true });
    const items = element("div", { class: "take-items" });
    const add = (/** @type {string} */ text, /** @type {() => Promise<void> | void} */ act) => {
      const made = button(text);
      made.addEventListener("click", () => this.#run(act));
      items.append(made);
      return made;
    };
    add("Scene file", () => this.#files(engine.sceneFile({ touchdown: present.touchdown, units: present.units })));
    add("Command", () => this.#showCommand());
    const holds = location.protocol === "file:" ? "It opens this file." : "It holds while this explorer runs, and with --port and --token-file after a restart, too.";
    add("Link", () => this.#copy(address(), `The link is copied. ${holds}`, `Copy it from here. ${holds}`));
    add("Histories, CSV", () => this.#files(engine.historyFile({ touchdown: present.touchdown, units: present.units, interval_s: 0.01 })));
    add("Histories, SVG", () => save("histories.svg", historiesSvg(this.#contents()), "image/svg+xml"));
    add("Picture, PNG", async () => {
      this.#stage.render();
      save("landing.png", await png(this.#stage.canvas));
    });
    add("Picture, SVG", () => this.#stageSvg());
    this.movie = add("Animation, WebM", () => this.#record());
    const { contour } = map;
    const opened = () => {
      if (!contour.map) throw new Error("open a map first");
      return contour.map;
    };
    add("Map, PNG", async () => opened() && save("map.png", await png(contour.canvas)));
    add("Map, SVG", () => {
      const svg = new SvgContext(contour.size[0], contour.size[1]);
      contour.paint(svg.context, opened());
      save("map.svg", svg.toString(), "image/svg+xml");
    });
    add("Surface, SVG", () => save("surface.svg", surfaceSvg(map.surface), "image/svg+xml"));
    this.root = element("details", { class: "take" }, element("summary", {}, "Take away"), element("div", { class: "menu" }, items, this.note, this.command));
    this.root.addEventListener("keydown", (event) => {
      if (event.key !== "Escape") return;
      this.root.open = false;
      this.root.querySelector("summary")?.focus();
    });
  }

  get #stage() {
    return this.replay.panels[0].view.stage;
  }

  #contents() {
    return this.replay.histories.charts.flatMap(({ offered, content }) => offered ?? content ?? []);
  }

  #stageSvg() {
    const { view } = this.replay.panels[0];
    const ground = view.lander?.ground;
    if (!ground) throw new Error("there is no landing yet");
    save("landing.svg", stageSvg(view.stage, ground.surface, ground.grid.step.value), "image/svg+xml");
  }

  /** @param {() => Promise<void> | void} act */
  async #run(act) {
    this.note.textContent = "";
    try {
      await act();
    } catch (error) {
      this.note.textContent = error instanceof Error ? error.message : String(error);
    }
  }

  /** @param {Promise<{ files: { name: string, text: string }[] }>} asked */
  async #files(asked) {
    for (const { name, text } of (await asked).files) save(name, text);
  }

  async #showCommand() {
    const { command } = await engine.command({ touchdown: this.present.touchdown, units: this.present.units });
    this.command.hidden = false;
    this.command.value = command;
    await this.#copy(command, "The command is copied.");
  }

  /** @param {string} text @param {string} done @param {string} [otherwise] where nothing can be copied */
  async #copy(text, done, otherwise = "Copy it from here:") {
    try {
      await navigator.clipboard.writeText(text);
      this.note.textContent = done;
    } catch {
      this.command.hidden = false;
      this.command.value = text;
      this.command.select();
      this.note.textContent = otherwise;
    }
  }

  async #record() {
    if (this.recording) {
      this.recording.abort();
      return;
    }
    this.recording = new AbortController();
    this.movie.textContent = "Stop recording";
    try {
      save("landing.webm", await record(this.#stage, this.replay.player, this.recording.signal));
    } finally {
      this.recording = undefined;
      this.movie.textContent = "Animation, WebM";
    }
  }
}
