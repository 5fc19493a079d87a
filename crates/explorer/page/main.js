import * as engine from "./engine/engine.js";
import { byId, element } from "./look/elements.js";
import { startTheme } from "./look/theme.js";
import { LandingTab } from "./landing/landing_tab.js";
import { Present } from "./present/present.js";

startTheme(byId("theme", HTMLButtonElement));
engine.connect();

const trouble = byId("trouble", HTMLElement);
/** @param {unknown} error */
function complain(error) {
  trouble.textContent = error instanceof Error ? error.message : String(error);
  trouble.hidden = false;
}

async function start() {
  const known = await engine.inputs();
  const present = new Present();
  present.source = known.sources[0].name;
  present.units = known.units;
  const source = byId("source", HTMLSelectElement);
  source.append(...known.sources.map(({ name, title }) => element("option", { value: name }, title)));
  const tab = new LandingTab(present, known.sources);
  byId("content", HTMLElement).append(tab.root);
  await tab.refresh();
}

start().catch(complain);
