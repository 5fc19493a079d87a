import { Color, DoubleSide, MeshBasicMaterial, MeshLambertMaterial } from "../vendor/three.js";
import { colours } from "../look/theme.js";

/** @typedef {ReturnType<typeof materials>} Materials */

/** What a lander and its marks are made of, in the colours in force. */
export function materials() {
  const now = colours();
  const solid = (/** @type {string} */ color) => new MeshLambertMaterial({ color });
  const flat = (/** @type {string} */ color, opacity = 1) =>
    new MeshBasicMaterial({ color, transparent: opacity < 1, opacity, side: DoubleSide, depthWrite: opacity === 1 });
  return {
    metal: solid("#d5d9de"),
    dark: solid("#4a5058"),
    foil: new MeshLambertMaterial({ color: "#d9a53a", flatShading: true }),
    panel: solid("#3f62b8"),
    white: solid("#eceae4"),
    earth: solid(now.scene.ground),
    honeycomb: new MeshLambertMaterial({ color: "#c8b37a", side: DoubleSide }),
    leaning: flat(now.jump, 0.22),
    downhill: flat(now.scene.gridLine),
    path: flat(now.scene.path),
    // Of copies each has a colour of its own.
    copies: solid("#ffffff"),
    marks: flat("#ffffff"),
    rod: new Color("#dfe3e8"),
    sleeve: new Color("#8b939d"),
    crushed: new Color("#c2410c"),
    stroked: new Color(now.bottomed),
    polygon: new Color(now.scene.polygon),
    critical: new Color(now.jump),
    force: new Color(now.curves[0]),
    blockForce: new Color(now.curves[3]),
    velocity: new Color(now.stable),
  };
}
