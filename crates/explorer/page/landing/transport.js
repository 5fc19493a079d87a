import { button, element } from "../look/elements.js";
import { fixed } from "../look/words.js";

/** Speeds that the picture may run at, of the true one. */
const SPEEDS = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1];
/** Room of a word at the time line, percent: ticks without it share their words. */
const CLOSE = 3;
/** Marks of events at the time line. */
const SHORT = /** @type {Record<string, string>} */ ({ "least-stability": "σ", verdict: "■", bottomed: "▼", failure: "✕" });

/** Play, pause, scrub, speed and events, for a player. */
export class TransportBar {
  /** @param {import("./player.js").Player} player @param {string} name of what is played, for screen readers */
  constructor(player, name) {
    this.player = player;
    this.playButton = button("▶", "Play");
    this.playButton.classList.add("play");
    this.slider = element("input", { type: "range", min: 0, max: 1, step: 0.001, value: 0, "aria-label": `Time of ${name}, s` });
    this.clock = element("output", { class: "clock" }, "0.000 s");
    this.ticks = element("div", { class: "ticks", "aria-hidden": "true" });
    this.speed = element("select", { "aria-label": "Speed" });
    for (const speed of SPEEDS) {
      this.speed.append(element("option", { value: speed }, speed === 1 ? "true speed" : `1/${Math.round(1 / speed)} speed`));
    }
    this.speed.value = String(player.speed);
    this.events = element("select", { "aria-label": "Go to an event" });
    const back = button("◂", "One hundredth of a second back");
    const forth = button("▸", "One hundredth of a second forth");
    const line = element("div", { class: "timeline" }, this.slider, this.ticks);
    this.root = element("div", { class: "transport", role: "group", "aria-label": `Playing ${name}` });
    this.root.append(this.playButton, back, forth, line, this.clock, this.speed, this.events);

    this.playButton.addEventListener("click", () => player.toggle());
    back.addEventListener("click", () => this.#step(-0.01));
    forth.addEventListener("click", () => this.#step(0.01));
    this.slider.addEventListener("input", () => {
      player.pause();
      player.go(Number(this.slider.value));
    });
    this.speed.addEventListener("change", () => {
      player.speed = Number(this.speed.value);
      player.dispatchEvent(new Event("speed"));
    });
    this.events.addEventListener("change", () => {
      player.pause();
      player.go(Number(this.events.value));
      this.events.selectedIndex = 0;
    });
    player.addEventListener("time", () => this.#showTime());
    player.addEventListener("state", () => this.#showState());
    this.#showState();
  }

  /** @param {number} by */
  #step(by) {
    this.player.pause();
    this.player.go(this.player.time + by);
  }

  /** @param {import("../engine/types.js").LandingEvent[]} events */
  setEvents(events) {
    const { end } = this.player;
    this.events.replaceChildren(element("option", { value: 0 }, "events …"));
    this.ticks.replaceChildren();
    /** Words of the ticks: those of ticks too close to each other stand at the first. @type {{ at: number, words: HTMLElement } | undefined} */
    let last;
    for (const { time_s, kind, title, leg } of events) {
      this.events.append(element("option", { value: time_s }, `${fixed(time_s, 3)} s  ${title}`));
      if (end <= 0 || time_s > end * 1.0001) continue;
      const at = (100 * time_s) / end;
      const tick = element("span", { class: `tick ${kind}` });
      tick.style.left = `${at}%`;
      this.ticks.append(tick);
      const short = SHORT[kind] ?? String(leg ?? "");
      const words = last?.words.textContent?.split(" ") ?? [];
      if (last && at - last.at < CLOSE * words.length) {
        if (!words.includes(short)) last.words.append(` ${short}`);
      } else {
        tick.append(short);
        last = { at, words: tick };
      }
    }
  }

  #showTime() {
    const { time, end } = this.player;
    this.slider.max = String(end || 1);
    this.slider.value = String(time);
    this.slider.setAttribute("aria-valuetext", `${fixed(time, 3)} s of ${fixed(end, 3)} s`);
    this.clock.textContent = `${fixed(time, 3)} s`;
  }

  #showState() {
    const { isPlaying } = this.player;
    this.playButton.textContent = isPlaying ? "❚❚" : "▶";
    this.playButton.setAttribute("aria-label", isPlaying ? "Pause" : "Play");
    this.playButton.title = isPlaying ? "Pause (space)" : "Play (space)";
  }
}
