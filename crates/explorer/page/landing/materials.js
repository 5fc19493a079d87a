import { Color, DoubleSide, MeshBasicMaterial, MeshStandardMaterial } from "../vendor/three.js";
import { colours } from "../look/theme.js";

/** @typedef {ReturnType<typeof materials>} Materials */

/** What a lander and its marks are made of, in the colours in force. */
export function materials() {
  const now = colours();
  const solid = (/** @type {string} */ color, metalness = 0.25, roughness = 0.55) =>
    new MeshStandardMaterial({ color, metalness, roughness });
  const flat = (/** @type {string} */ color, opacity = 1) =>
    new MeshBasicMaterial({ color, transparent: opacity < 1, opacity, side: DoubleSide, depthWrite: opacity === 1 });
  return {
    metal: solid("#d5d9de", 0.1, 0.55),
    dark: solid("#4a5058"),
    foil: new MeshStandardMaterial({ color: "#d9a53a", metalness: 0.45, roughness: 0.38, flatShading: true }),
    panel: solid("#3f62b8", 0.1, 0.45),
    white: solid("#eceae4", 0, 0.7),
    rod: solid("#dfe3e8", 0.5, 0.25),
    sleeve: solid("#8b939d"),
    honeycomb: new MeshStandardMaterial({ color: "#c8b37a", metalness: 0.05, roughness: 0.8, side: DoubleSide }),
    crushed: new Color("#c2410c"),
    stroked: new Color(colours().bottomed),
    polygon: flat(now.scene.polygon),
    critical: flat(now.jump),
    leaning: flat(now.jump, 0.22),
    plumb: flat(now.scene.path),
    force: flat(now.curves[0]),
    blockForce: flat(now.curves[3]),
    downhill: flat(now.scene.gridLine),
    velocity: flat(now.stable),
    path: flat(now.scene.path),
  };
}
