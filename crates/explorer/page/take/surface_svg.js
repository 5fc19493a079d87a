import { colours } from "../look/theme.js";
import { sceneSvg } from "./scene_svg.js";

/** The surface of V_H as SVG, as it is turned. @param {import("../map/surface_view.js").SurfaceView} view */
export function surfaceSvg({ scene, camera, sun, root, map }) {
  if (!map || root.hidden || root.clientWidth === 0) throw new Error("open a map with a surface first");
  const light = sun.position.clone().normalize();
  return sceneSvg({ scene, camera, light, size: [root.clientWidth, root.clientHeight], paper: colours().paper });
}
