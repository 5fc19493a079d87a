import { EngineError } from "./engine.js";

/**
 * Asks the WebAssembly module inside an exported page.
 * @param {HTMLElement} _inside the element that holds the module
 * @returns {import("./engine.js").Transport}
 */
export function overModule(_inside) {
  return async () => {
    throw new EngineError({ message: "this page has no engine inside", key: null, value: null, allowed: null });
  };
}
