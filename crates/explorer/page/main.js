import * as engine from "./engine/engine.js";
import { byId, element } from "./look/elements.js";
import { startTheme } from "./look/theme.js";
import { Tabs } from "./look/tabs.js";
import { MapTab } from "./map/map_tab.js";
import { LandingTab } from "./landing/landing_tab.js";
import { fromAddress, toAddress } from "./present/address.js";
import { Present } from "./present/present.js";
import { TakeAway } from "./take/take_away.js";
import { SampleTab } from "./sample/sample_tab.js";

/** How long nothing changes before the address takes it, ms. */
const CALM = 250;

startTheme(byId("theme", HTMLButtonElement));
engine.connect();

const trouble = byId("trouble", HTMLElement);
/** @param {unknown} error */
function complain(error) {
  trouble.textContent = error instanceof Error ? error.message : String(error);
  trouble.hidden = false;
}
window.addEventListener("unhandledrejection", (event) => complain(event.reason));

async function start() {
  const known = await engine.inputs();
  const present = new Present();
  present.source = known.sources[0].name;
  present.units = known.units;

  const tabs = new Tabs(byId("tabs", HTMLElement), byId("content", HTMLElement));
  const landing = new LandingTab(present, known.sources);
  tabs.add("landing", "Landing", landing.root);

  const explore = (/** @type {Event} */ event) => {
    present.replace(/** @type {CustomEvent<import("./engine/types.js").Touchdown>} */ (event).detail);
    tabs.choose("landing");
  };
  const boundaries = known.results.filter(({ kind }) => kind !== "sample");
  const map = boundaries.length ? new MapTab(boundaries, present) : undefined;
  if (map) {
    tabs.add("map", "Map", map.root);
    map.addEventListener("explore", explore);
    tabs.addEventListener("chosen", () => tabs.chosen === "map" && map.open());
  }

  const samples = known.results.filter(({ kind }) => kind === "sample");
  const sample = samples.length ? new SampleTab(samples, present) : undefined;
  if (sample) {
    tabs.add("dispersion", "Dispersion", sample.root);
    sample.addEventListener("explore", explore);
    tabs.addEventListener("chosen", () => tabs.chosen === "dispersion" && sample.open());
  }

  const source = byId("source", HTMLSelectElement);
  source.append(...known.sources.map(({ name, title }) => element("option", { value: name }, title)));
  source.addEventListener("change", () => present.replace({ source: source.value, values: {} }));
  const units = byId("units", HTMLSelectElement);
  units.addEventListener("change", () => present.setUnits(units.value === "SI" ? "SI" : "US"));

  const { player, panels } = landing.replay;
  const address = () => {
    const tab = tabs.chosen === "landing" ? "" : (tabs.chosen ?? "");
    const [panel] = panels;
    const view = panel.view.view === "corner" ? "" : panel.view.view;
    const t = player.isPlaying || player.time >= player.end ? "" : player.time.toFixed(3);
    return toAddress(present, { tab, view, t, ...map?.state(), ...sample?.state() });
  };
  byId("take", HTMLElement).append(new TakeAway(present, landing.replay, map, () => location.href.split("#")[0] + address()).root);

  const restore = async () => {
    const { source: named, units: wanted, values, extra } = fromAddress(location.hash);
    if (wanted === "US" || wanted === "SI") present.units = wanted;
    const isKnown = known.sources.some(({ name }) => name === named);
    if (named !== null && isKnown) present.source = named;
    map?.restore(extra);
    sample?.restore(extra);
    const isView = panels[0].viewButtons?.some(({ dataset }) => dataset.view === extra.view);
    if (isView) panels[0].view.view = /** @type {import("./landing/stage.js").View} */ (extra.view);
    present.replace({ source: present.source, values: named === null || isKnown ? values : {} });
    tabs.choose(extra.tab ?? "landing");
    await landing.refresh();
    if (extra.t) player.go(Number(extra.t));
  };
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let later;
  const keep = () => {
    source.value = present.source;
    units.value = present.units;
    clearTimeout(later);
    later = setTimeout(() => {
      if (address() !== location.hash) history.replaceState(null, "", address());
    }, CALM);
  };
  for (const kind of ["values", "units"]) present.addEventListener(kind, keep);
  for (const kind of ["time", "state"]) player.addEventListener(kind, keep);
  for (const kind of ["loaded", "landed"]) map?.addEventListener(kind, keep);
  for (const kind of ["loaded", "axes"]) sample?.addEventListener(kind, keep);
  panels[0].root.addEventListener("view", keep);
  tabs.addEventListener("chosen", keep);
  window.addEventListener("hashchange", restore);
  await Promise.all([restore(), landing.sliders.refresh()]);
}

start().catch(complain);
