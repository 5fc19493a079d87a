/**
 * Runs one task at a time; of those that arrive meanwhile only the newest is run after it. What moves a slider asks for more
 * than can be answered, and only the last of it matters.
 */
export class Newest {
  /** @type {(() => Promise<void>) | undefined} */
  #waiting;
  /** @type {Promise<void> | undefined} */
  #busy;

  /** Ends when nothing waits any more. @param {() => Promise<void>} task */
  run(task) {
    this.#waiting = task;
    this.#busy ??= this.#work();
    return this.#busy;
  }

  /** Ends with what runs and waits; nothing where all is done. */
  get busy() {
    return this.#busy;
  }

  async #work() {
    try {
      while (this.#waiting) {
        const next = this.#waiting;
        this.#waiting = undefined;
        await next();
      }
    } finally {
      this.#busy = undefined;
    }
  }
}
