import { EngineError } from "./engine.js";

/** What the worker runs after the text of `wasm/module.js`: it answers one request after the other. */
const WORKER = `
let answer;
onmessage = async ({ data: { inside, name, request } }) => {
  try {
    if (inside !== undefined) answer = await openExported(inside);
    postMessage({ answer: inside === undefined ? answer(name, request) : null });
  } catch (error) {
    postMessage({ error: { key: null, value: null, allowed: null, message: String(error), ...error } });
  }
};
`;

/** @typedef {{ name: string, request: object, signal: AbortSignal | undefined, done: (answer: any) => void, fail: (error: unknown) => void }} Job */

/**
 * Asks the WebAssembly module inside an exported page, in a worker, so that the page never stands still.
 * @param {HTMLElement} inside the element that holds the module
 * @returns {import("./engine.js").Transport}
 */
export function overModule(inside) {
  // An exported page has its scripts as addresses that hold them. From disk it may start only workers that import nothing.
  const [, packed] = import.meta.resolve("page/wasm/module.js").split(";base64,");
  const source = new TextDecoder().decode(Uint8Array.from(atob(packed), (digit) => digit.charCodeAt(0)));
  const script = new Blob([source.replace(/^export /gm, ""), WORKER], { type: "text/javascript" });
  const worker = new Worker(URL.createObjectURL(script));
  /** @type {Job[]} */
  const waiting = [];
  /** @type {Job | undefined} */
  let current;
  const next = () => {
    if (current) return;
    // What is shown goes before what only fills in.
    const first = waiting.findIndex(({ name }) => name === "landing");
    const [job] = waiting.splice(Math.max(first, 0), 1);
    if (!job) return;
    if (job.signal?.aborted) {
      job.fail(job.signal.reason);
      next();
      return;
    }
    current = job;
    worker.postMessage({ name: job.name, request: job.request });
  };
  const begin = { name: "", request: {}, signal: undefined, done: () => {}, fail: (/** @type {unknown} */ error) => (broken = error) };
  /** @type {unknown} */
  let broken;
  current = begin;
  worker.postMessage({ inside: inside.textContent });
  worker.addEventListener("message", ({ data }) => {
    const job = current;
    current = undefined;
    if (data.error) job?.fail(new EngineError(data.error));
    else job?.done(data.answer);
    if (broken) for (const { fail } of waiting.splice(0)) fail(broken);
    next();
  });
  worker.addEventListener("error", (event) => {
    broken = new EngineError({ message: `the engine inside the page does not start: ${event.message}`, key: null, value: null, allowed: null });
    for (const { fail } of waiting.splice(0)) fail(broken);
  });
  return (name, request, signal) => new Promise((done, fail) => {
    if (broken) {
      fail(broken);
      return;
    }
    waiting.push({ name, request, signal, done, fail });
    next();
  });
}
