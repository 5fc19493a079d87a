// Writes the libraries of the page into ../../page/vendor from the fixed versions of package-lock.json.
// With --check it only compares, and fails where what is committed differs.
import { readFile, writeFile, mkdir } from "node:fs/promises";
import { build } from "esbuild";

const target = new URL("../../page/vendor/", import.meta.url);
const modules = new URL("node_modules/", import.meta.url);
const isCheck = process.argv.includes("--check");

const bundles = {
  "three.js": 'export * from "three"; export { OrbitControls } from "three/addons/controls/OrbitControls.js";',
  "uplot.js": 'export { default } from "uplot";',
};

/** @type {Record<string, string>} */
const files = {};
for (const [name, contents] of Object.entries(bundles)) {
  const result = await build({
    stdin: { contents, resolveDir: new URL(".", import.meta.url).pathname },
    bundle: true,
    minify: true,
    write: false,
    format: "esm",
    target: "es2022",
    legalComments: "inline",
  });
  files[name] = result.outputFiles[0].text;
}
for (const [name, path] of Object.entries({
  "uplot.css": "uplot/dist/uPlot.min.css",
  "three.LICENSE": "three/LICENSE",
  "uplot.LICENSE": "uplot/LICENSE",
})) {
  files[name] = await readFile(new URL(path, modules), "utf8");
}

await mkdir(target, { recursive: true });
for (const [name, text] of Object.entries(files)) {
  const path = new URL(name, target);
  if (!isCheck) {
    await writeFile(path, text);
  } else if ((await readFile(path, "utf8").catch(() => "")) !== text) {
    console.error(`crates/explorer/page/vendor/${name} is not what vendor.mjs writes`);
    process.exitCode = 1;
  }
}
