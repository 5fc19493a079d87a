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

const content = byId("content", HTMLElement);
byId("skip", HTMLAnchorElement).addEventListener("click", (event) => {
  // The address holds what is shown: an anchor would replace it.
  event.preventDefault();
  content.focus();
});

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

  const tabs = new Tabs(byId("tabs", HTMLElement), content);
  const landing = new LandingTab(present, known.sources);
  tabs.add("landing", "Landing", landing.root);

  const explore = (/** @type {Event} */ event) => {
    present.replace(/** @type {CustomEvent<import("./engine/types.js").Touchdown>} */ (event).detail);
    tabs.choose("landing");
  };
  const boundaries = known.results.filter(({ kind }) => kind !== "sample");
  const map = new MapTab(boundaries, present, known.sources);
  tabs.add("map", "Map", map.root);
  map.addEventListener("explore", explore);
  tabs.addEventListener("chosen", () => tabs.chosen === "map" && map.open());

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
    return toAddress(present, { tab, view, t, ...landing.kept.state(), ...map.state(), ...sample?.state() });
  };
  byId("take", HTMLElement).append(new TakeAway(present, landing.replay, map, () => location.href.split("#")[0] + address()).root);

  /** Whether what is shown comes from the address, and whether somebody went a step since the address was written. */
  let isRestoring = false;
  let isStep = false;
  const restore = async () => {
    isRestoring = true;
    const { source: named, units: wanted, values, extra } = fromAddress(location.hash);
    if (wanted === "US" || wanted === "SI") present.units = wanted;
    const names = (/** @type {{ name: string }[]} */ list) => list.map(({ name }) => name);
    const views = (panels[0].viewButtons ?? []).map(({ dataset }) => String(dataset.view));
    const missing = [
      absent("input", named, names(known.sources)),
      absent("units", wanted, ["US", "SI"]),
      absent("tab", extra.tab, [...tabs.tabs.keys()]),
      absent("view", extra.view, views),
      absent("results", extra.results, names(boundaries)),
      absent("sample", extra.sample, names(samples)),
    ].filter(Boolean);
    const isKnown = named === null || known.sources.some(({ name }) => name === named);
    if (named !== null && isKnown) present.source = named;
    void landing.kept.restore(extra);
    map.restore(extra);
    sample?.restore(extra);
    if (views.includes(extra.view)) panels[0].view.view = /** @type {import("./landing/stage.js").View} */ (extra.view);
    present.replace({ source: present.source, values: isKnown ? values : {} });
    tabs.choose(extra.tab && tabs.tabs.has(extra.tab) ? extra.tab : "landing");
    if (missing.length) complain(`This link is not of these files. ${missing.join(" ")}`);
    await landing.newest.busy;
    if (extra.t) player.go(Number(extra.t));
    isRestoring = false;
  };
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let later;
  const keep = () => {
    source.value = present.source;
    units.value = present.units;
    clearTimeout(later);
    later = setTimeout(() => {
      // Steps, unlike sliders, are gone back to.
      if (address() !== location.hash) history[isStep ? "pushState" : "replaceState"](null, "", address());
      isStep = false;
    }, CALM);
  };
  const step = () => (isStep ||= !isRestoring);
  present.addEventListener("replaced", step);
  tabs.addEventListener("chosen", step);
  for (const kind of ["values", "units"]) present.addEventListener(kind, keep);
  present.addEventListener("values", () => (trouble.hidden = true));
  landing.kept.addEventListener("changed", keep);
  for (const kind of ["time", "state"]) player.addEventListener(kind, keep);
  for (const kind of ["loaded", "landed"]) map.addEventListener(kind, keep);
  for (const kind of ["loaded", "axes", "selected"]) sample?.addEventListener(kind, keep);
  panels[0].root.addEventListener("view", keep);
  tabs.addEventListener("chosen", keep);
  window.addEventListener("hashchange", restore);
  await restore();
  const isStill = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
  if (!isStill && player.time >= player.end) player.play();
}

/**
 * Says what a link names that is not there; nothing where all is.
 * @param {string} kind
 * @param {string | null | undefined} named
 * @param {string[]} known
 */
function absent(kind, named, known) {
  if (!named || known.includes(named)) return "";
  return `It names the ${kind} "${named}"; there ${known.length ? `is ${known.join(", ")}` : "is none"}.`;
}

start().catch(complain);
