/** The time that is shown, and how it runs. */
export class Player extends EventTarget {
  constructor() {
    super();
    this.time = 0;
    this.end = 0;
    this.speed = 0.5;
    this.isPlaying = false;
  }

  /** The end of the landing, s; a time beyond it is put back. @param {number} end @param {boolean} [isAtEnd] go there */
  setEnd(end, isAtEnd = false) {
    const wasAtEnd = this.time >= this.end;
    this.end = end;
    this.go(isAtEnd || (wasAtEnd && !this.isPlaying) ? end : Math.min(this.time, end));
  }

  /** @param {number} time s */
  go(time) {
    this.time = Math.min(Math.max(time, 0), this.end);
    this.dispatchEvent(new Event("time"));
  }

  toggle() {
    if (this.isPlaying) this.pause();
    else this.play();
  }

  play() {
    if (this.isPlaying || this.end <= 0) return;
    if (this.time >= this.end) this.go(0);
    this.isPlaying = true;
    this.dispatchEvent(new Event("state"));
    /** @type {number | undefined} */
    let last;
    const step = (/** @type {number} */ now) => {
      if (!this.isPlaying) return;
      // The first frame shows where it starts, however long the page had been busy.
      const passed = last === undefined ? 0 : Math.min((now - last) / 1000, 0.25);
      last = now;
      this.go(this.time + passed * this.speed);
      if (this.time >= this.end) this.pause();
      else requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  pause() {
    if (!this.isPlaying) return;
    this.isPlaying = false;
    this.dispatchEvent(new Event("state"));
  }
}
