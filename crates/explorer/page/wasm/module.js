// @ts-check
/** The interface as a WebAssembly module: the same names, requests and answers as over HTTP. */

/**
 * @typedef {object} Exports What the module exports.
 * @property {WebAssembly.Memory} memory
 * @property {(length: number) => number} explorer_input
 * @property {() => number} explorer_output
 * @property {() => number} explorer_open
 * @property {(nameLength: number) => number} explorer_answer
 */

/**
 * Makes an interface of what an exported page has inside.
 *
 * @param {string} inside the text of the element `touchdown-engine`
 * @returns {Promise<(name: string, request: object) => any>} as {@link openModule}
 */
export async function openExported(inside) {
  const { module, opened } = JSON.parse(inside);
  const packed = Uint8Array.from(atob(module), (digit) => digit.charCodeAt(0));
  const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return openModule(await WebAssembly.compile(await new Response(unpacked).arrayBuffer()), opened);
}

/**
 * Makes an interface of a compiled module.
 *
 * @param {WebAssembly.Module} module
 * @param {object} opened what is explored: `files`, `copies` and `units`, as `touchdown explore --export` writes them
 * @returns {Promise<(name: string, request: object) => any>} Answers a request; throws complaints as answers have them.
 */
export async function openModule(module, opened) {
  const text = { encoder: new TextEncoder(), decoder: new TextDecoder() };
  const exports = await start();

  /** @returns {Promise<Exports>} */
  async function start() {
    const instance = await WebAssembly.instantiate(module, {});
    const exports = /** @type {Exports} */ (/** @type {unknown} */ (instance.exports));
    const said = call(exports, [JSON.stringify(opened)], () => exports.explorer_open());
    if (said !== "") throw JSON.parse(said).error;
    return exports;
  }

  /**
   * @param {Exports} exports
   * @param {string[]} parts
   * @param {(lengths: number[]) => number} ask
   */
  function call(exports, parts, ask) {
    const bytes = parts.map((part) => text.encoder.encode(part));
    const lengths = bytes.map((part) => part.length);
    let place = exports.explorer_input(lengths.reduce((sum, length) => sum + length, 0));
    // The memory may have grown: a view is good for one call.
    const memory = new Uint8Array(exports.memory.buffer);
    for (const part of bytes) {
      memory.set(part, place);
      place += part.length;
    }
    const length = ask(lengths);
    return text.decoder.decode(new Uint8Array(exports.memory.buffer, exports.explorer_output(), length));
  }

  return (name, request) => {
    const said = call(exports, [name, JSON.stringify(request)], ([length]) => exports.explorer_answer(length));
    const answer = JSON.parse(said);
    if (answer.error !== undefined) throw answer.error;
    return answer;
  };
}
