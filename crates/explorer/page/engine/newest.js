/**
 * Runs one task at a time; of those that arrive meanwhile only the newest is run after it. What moves a slider asks for more
 * than can be answered, and only the last of it matters.
 */
export class Newest {
  /** @type {(() => Promise<void>) | undefined} */
  #waiting;
  #isBusy = false;

  /** @param {() => Promise<void>} task */
  async run(task) {
    this.#waiting = task;
    if (this.#isBusy) return;
    this.#isBusy = true;
    try {
      while (this.#waiting) {
        const next = this.#waiting;
        this.#waiting = undefined;
        await next();
      }
    } finally {
      this.#isBusy = false;
    }
  }

  /** Whether a newer task waits. */
  get isOutdated() {
    return this.#waiting !== undefined;
  }
}
