import { EngineError } from "./engine.js";

/**
 * Asks the server from which the page came.
 * @param {string} name
 * @param {object} request
 * @param {AbortSignal} [signal]
 */
export async function overHttp(name, request, signal) {
  const headers = { "Content-Type": "application/json" };
  const init = { method: "POST", headers, body: JSON.stringify(request), signal };
  let response;
  try {
    response = await fetch(`api/${name}`, init);
  } catch (error) {
    if (signal?.aborted) throw error;
    throw new EngineError({ message: "the program does not answer; has it ended?", key: null, value: null, allowed: null });
  }
  const answer = await response.json().catch(() => ({}));
  if (response.ok) return answer;
  const fault = { message: `${name}: status ${response.status}`, key: null, value: null, allowed: null };
  throw new EngineError(answer.error ?? fault);
}
