/** Colours of canvases and of the scene, light and dark. Those of classes and curves are those of the pictures of results. */

/** @typedef {import("../engine/types.js").Class} Class */

const LIGHT = {
  text: "#262626",
  paleText: "#606060",
  grid: "#e2e2e2",
  paper: "#ffffff",
  stable: "#008264",
  unstable: "#005aa0",
  bottomed: "#d55e00",
  failure: "#96286e",
  undecided: "#696969",
  regions: { stable: "#ffffff", unstable: "#cedff0", bottomed: "#f8d6ba", failure: "#f0e0ec", undecided: "#e2e2da" },
  curves: ["#005aa0", "#d55e00", "#008264", "#b4508c", "#785a14", "#3c3c3c", "#50aadc", "#e6a000"],
  jump: "#be1e64",
  lowest: "#e65a00",
  scene: {
    sky: "#dfe6ee", ground: "#b9b3a8", gridLine: "#6f6a62", haze: "#dfe6ee", path: "#262626", polygon: "#ffffff",
    shine: 2.6, ambient: 1.5, ghost: "#8a8f96",
  },
};

/** @type {typeof LIGHT} */
const DARK = {
  text: "#e6e6e6",
  paleText: "#a8a8a8",
  grid: "#3a3f46",
  paper: "#15181c",
  stable: "#3cc49b",
  unstable: "#62aeee",
  bottomed: "#f5924a",
  failure: "#dc82bb",
  undecided: "#b0b0b0",
  regions: { stable: "#15181c", unstable: "#1f3d5c", bottomed: "#5c3417", failure: "#4d2640", undecided: "#3d3d38" },
  curves: ["#62aeee", "#f5924a", "#3cc49b", "#e08cc0", "#cfae5c", "#d0d0d0", "#9ad4f5", "#ffc83d"],
  jump: "#ff5c9f",
  lowest: "#ff8a3c",
  scene: {
    sky: "#0b0e13", ground: "#69655e", gridLine: "#a9a397", haze: "#0b0e13", path: "#ffd75e", polygon: "#ffffff",
    shine: 2.4, ambient: 0.8, ghost: "#70757c",
  },
};

const prefersDark = window.matchMedia("(prefers-color-scheme: dark)");
const changes = new EventTarget();
const KEY = "touchdown-theme";

/** @type {"light" | "dark" | "auto"} */
let choice = "auto";

export const isDark = () => choice === "dark" || (choice === "auto" && prefersDark.matches);

/** The colours in force. */
export const colours = () => (isDark() ? DARK : LIGHT);

/** @param {Class} of */
export const classColour = (of) => colours()[of];

/** @param {Class} of */
export const regionColour = (of) => colours().regions[of];

/** Colour of a curve among several. @param {number} index */
export const curveColour = (index) => colours().curves[index % colours().curves.length];

/** A colour nearer to that of the paper. @param {string} colour as #rrggbb */
export function pale(colour) {
  const part = (/** @type {string} */ of, /** @type {number} */ at) => parseInt(of.slice(at, at + 2), 16);
  const mixed = [1, 3, 5].map((at) => Math.round(0.6 * part(colour, at) + 0.4 * part(colours().paper, at)));
  return `#${mixed.map((value) => value.toString(16).padStart(2, "0")).join("")}`;
}

/** @param {() => void} listener */
export const onTheme = (listener) => changes.addEventListener("change", listener);

function apply() {
  document.documentElement.dataset.theme = isDark() ? "dark" : "light";
  changes.dispatchEvent(new Event("change"));
}

/** Follows the system until the button is pressed. @param {HTMLButtonElement} button */
export function startTheme(button) {
  const known = readChoice();
  if (known) choice = known;
  prefersDark.addEventListener("change", apply);
  button.addEventListener("click", () => {
    choice = isDark() ? "light" : "dark";
    try {
      localStorage.setItem(KEY, choice);
    } catch {
      // A page opened from disk may have no storage; the choice then lasts as long as the page.
    }
    apply();
  });
  apply();
}

function readChoice() {
  try {
    const known = localStorage.getItem(KEY);
    return known === "light" || known === "dark" ? known : undefined;
  } catch {
    return undefined;
  }
}
