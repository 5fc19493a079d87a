/** What the page asks for: one function a request, whatever carries it. */

import { overHttp } from "./http.js";
import { overModule } from "./module.js";

/** A complaint of the engine, in the words of the command line. */
export class EngineError extends Error {
  /** @param {import("./types.js").Complaint} complaint */
  constructor(complaint) {
    super(complaint.message);
    this.complaint = complaint;
  }
}

/**
 * Carries a request: a name and a value, to be answered by a value. Fails with an {@link EngineError}.
 * @typedef {(name: string, request: object, signal?: AbortSignal) => Promise<any>} Transport
 */

/** @type {Transport | undefined} */
let transport;

/** Chooses the transport: the module that an exported page has inside, otherwise the server of the page. */
export function connect() {
  const inside = document.getElementById("touchdown-engine");
  transport = inside ? overModule(inside) : overHttp;
}

/**
 * @param {string} name
 * @param {object} request
 * @param {AbortSignal} [signal]
 * @returns {Promise<any>}
 */
function ask(name, request, signal) {
  if (!transport) throw new Error("no connection");
  return transport(name, request, signal);
}

/** @typedef {import("./types.js").Touchdown} Touchdown */

/** @returns {Promise<import("./types.js").Inputs>} */
export const inputs = () => ask("inputs", {});

/** @param {Touchdown} touchdown @returns {Promise<import("./types.js").Parameter[]>} */
export const parameters = async (touchdown) => (await ask("parameters", { touchdown })).parameters;

/**
 * @param {{ touchdown: Touchdown, units?: string, interval_s?: number, history?: boolean, drawing?: boolean }} request
 * @param {AbortSignal} [signal]
 * @returns {Promise<import("./types.js").Landing>}
 */
export const landing = (request, signal) => ask("landing", request, signal);

/**
 * @param {{ touchdown: Touchdown, from_fps: number, to_fps: number, known: import("./types.js").StripLanding[],
 *   most?: number, resolution_fps?: number }} request
 * @param {AbortSignal} [signal]
 * @returns {Promise<import("./types.js").Strip>}
 */
export const strip = (request, signal) => ask("strip", request, signal);

/**
 * @param {{ touchdown: Touchdown, from_fps: number, to_fps: number }} request
 * @param {AbortSignal} [signal]
 * @returns {Promise<import("./types.js").Bands>}
 */
export const bands = (request, signal) => ask("bands", request, signal);

/**
 * @param {{ touchdown: Touchdown, axes: string[], place: number[], from_fps: number, to_fps: number }} request
 * @param {AbortSignal} [signal]
 * @returns {Promise<{ heading: string, row: string }>}
 */
export const boundary = (request, signal) => ask("boundary", request, signal);

/**
 * @param {{ results?: string, computed?: import("./types.js").Computed, axes?: string[], fixed?: Record<string, number | string>, units: string }} request
 * @returns {Promise<import("./types.js").MapAnswer>}
 */
export const map = (request) => ask("map", request);

/**
 * @param {{ results?: string, computed?: import("./types.js").Computed, place: Record<string, number | string>, units: string }} request
 * @returns {Promise<import("./types.js").At>}
 */
export const at = (request) => ask("at", request);

/** @param {{ results: string, units: string }} request @returns {Promise<import("./types.js").Sample>} */
export const sample = (request) => ask("sample", request);

/**
 * @param {{ results: string, column: string, within: import("./types.js").Range[], units: string }} request
 * @returns {Promise<import("./types.js").Bins>}
 */
export const bins = (request) => ask("bins", request);

/** @param {{ results?: string, computed?: import("./types.js").Computed, within: import("./types.js").Range[], units: string }} request
 * @returns {Promise<{ files: { name: string, text: string }[] }>} */
export const tableFile = (request) => ask("table_file", request);

/** @param {{ touchdown: Touchdown, units: string }} request
 * @returns {Promise<{ files: { name: string, text: string }[] }>} */
export const sceneFile = (request) => ask("scene_file", request);

/** @param {{ touchdown: Touchdown, units: string, interval_s?: number }} request
 * @returns {Promise<{ files: { name: string, text: string }[] }>} */
export const historyFile = (request) => ask("history_file", request);

/** @param {{ touchdown: Touchdown, units: string }} request @returns {Promise<{ command: string, needs: string[] }>} */
export const command = (request) => ask("command", request);
