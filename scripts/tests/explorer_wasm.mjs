// The module inside an exported page answers as the server does, bit for bit.
//
//     node explorer_wasm.mjs PAGE.html ADDRESS
//
// PAGE.html was exported with the files with which the server at ADDRESS was started.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { openExported } from "../../crates/explorer/page/wasm/module.js";

const [page, address] = process.argv.slice(2);
const inside = /<script type="application\/json" id="touchdown-engine">(.*?)<\/script>/s.exec(readFileSync(page, "utf8"));
const module = await openExported(inside[1]);

/** The answer, or the complaint, of the server. */
async function server(name, request) {
  const headers = { "Content-Type": "application/json" };
  for (;;) {
    const response = await fetch(`${address}api/${name}`, { method: "POST", headers, body: JSON.stringify(request) });
    const answer = await response.json();
    if (response.status !== 429) return answer;
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
}

/** The same of the module. */
function inModule(name, request) {
  try {
    return module(name, request);
  } catch (error) {
    if (error instanceof WebAssembly.RuntimeError) throw error;
    return { error };
  }
}

// A fixed sequence that looks random (Lehmer).
let seed = 1966;
const draw = (from, to) => {
  seed = (seed * 48271) % 2147483647;
  return from + ((to - from) * seed) / 2147483647;
};

const { sources, results } = await server("inputs", {});
const requests = [["inputs", {}]];
for (const { name: source } of sources) {
  for (let index = 0; index < 12; index++) {
    const values = {
      horizontal_velocity_fps: draw(0, 25),
      vertical_velocity_fps: draw(5, 20),
      cross_slope_deg: draw(-180, 180),
      slope_deg: draw(-20, 30),
      roll_deg: draw(-60, 60),
      pitch_deg: draw(-20, 20),
      friction: draw(0.2, 1.5),
      "footing[2].height_ft": draw(-0.5, 0.5),
    };
    requests.push(["landing", { touchdown: { source, values }, units: index % 2 ? "SI" : "US" }]);
  }
  requests.push(["parameters", { touchdown: { source } }], ["strip", { touchdown: { source } }]);
  requests.push(["bands", { touchdown: { source }, from_fps: 8, to_fps: 14 }]);
  // Where none takes long: the server gives an answer up after half a minute, and other work may be on the cores.
  requests.push(["boundary", { touchdown: { source }, axes: ["cross_slope_deg", "roll_deg"], place: [90, 30] }]);
  for (const name of ["scene_file", "history_file", "command"]) requests.push([name, { touchdown: { source } }]);
}
for (const { name: results_, axes } of results) {
  const place = Object.fromEntries(axes.map((axis) => [axis, 7]));
  requests.push(["map", { results: results_ }], ["at", { results: results_, place }], ["table_file", { results: results_, units: "SI" }]);
}
requests.push(["landing", { touchdown: { values: { slope_deg: 95 } } }], ["landing", { what: 1 }], ["nothing", {}]);

// The server first: it closes connections on which nothing comes for a while, and the module may take longer than that.
const answers = [];
for (const [name, request] of requests) answers.push(await server(name, request));
for (const [index, [name, request]] of requests.entries()) {
  assert.deepStrictEqual(inModule(name, request), answers[index], `${name} ${JSON.stringify(request)}`);
}
console.log(`${requests.length} answers of the module are those of the server`);
