import {
  Color, DoubleSide, InstancedMesh, Line, LineSegments, Matrix4, Mesh, MeshBasicMaterial, ShadowMaterial, Sprite, Vector3,
} from "../vendor/three.js";
import { SvgContext } from "./svg_context.js";

/** @typedef {(point: Vector3) => [number, number]} Project */
/** @typedef {{ depth: number, points: [number, number][], colour: string, opacity: number }} Facet */
/**
 * A scene to be drawn: `light` is the direction to it, and `below` draws what lies behind all facets.
 * @typedef {{ scene: import("../vendor/three.js").Scene, camera: import("../vendor/three.js").PerspectiveCamera, light: Vector3,
 *   size: [number, number], paper: string, below?: (svg: SvgContext, project: Project) => void, without?: Mesh }} View
 */

/** Longest piece of a line that is before or behind facets as a whole. */
const PIECE = 0.15;
const placed = new Matrix4();
const [tint, painted] = [new Color(), new Color()];
const [a, b, c, normal] = [0, 1, 2, 3].map(() => new Vector3());

/** A scene as SVG: facets from back to front. @param {View} view */
export function sceneSvg(view) {
  const { scene, camera, size: [width, height] } = view;
  const svg = new SvgContext(width, height);
  scene.updateMatrixWorld();
  svg.fillStyle = view.paper;
  svg.fillRect(0, 0, width, height);
  const project = (/** @type {Vector3} */ point) => {
    point.project(camera);
    return /** @type {[number, number]} */ ([(0.5 + 0.5 * point.x) * width, (0.5 - 0.5 * point.y) * height]);
  };
  view.below?.(svg, project);
  const facets = facetsOf(view, project);
  facets.sort((one, other) => other.depth - one.depth);
  for (const { points, colour, opacity } of facets) {
    svg.beginPath();
    points.forEach(([x, y], index) => (index ? svg.lineTo(x, y) : svg.moveTo(x, y)));
    svg.fillStyle = svg.strokeStyle = colour;
    svg.lineWidth = points.length > 2 ? 0.4 : 0.8;
    svg.globalAlpha = opacity;
    if (points.length > 2) {
      svg.closePath();
      svg.fill();
    }
    if (opacity === 1 || points.length === 2) svg.stroke();
  }
  drawWords(svg, scene, project);
  return svg.toString();
}

/** @param {SvgContext} svg @param {import("../vendor/three.js").Scene} scene @param {Project} project */
function drawWords(svg, scene, project) {
  svg.globalAlpha = 1;
  svg.font = "13px";
  svg.textAlign = "center";
  scene.traverseVisible((part) => {
    if (!(part instanceof Sprite)) return;
    svg.fillStyle = part.userData.colour;
    svg.fillText(part.userData.text, ...project(part.getWorldPosition(a)));
  });
}

/** @param {View} view @param {Project} project @returns {Facet[]} */
function facetsOf({ scene, camera, light, without }, project) {
  /** @type {Facet[]} */
  const facets = [];
  const add = (/** @type {Vector3[]} */ corners, /** @type {number} */ shade, /** @type {number} */ opacity, nearer = 1) => {
    const depth = (nearer * corners.reduce((sum, corner) => sum + corner.distanceTo(camera.position), 0)) / corners.length;
    const points = corners.map((corner) => project(corner));
    const { r, g, b: blue } = painted.copy(tint).convertLinearToSRGB();
    const rgb = [r, g, blue].map((value) => Math.round(255 * Math.min(value * shade, 1)).toString(16).padStart(2, "0"));
    facets.push({ depth, points, colour: `#${rgb.join("")}`, opacity });
  };
  const addMesh = (/** @type {Mesh} */ part, /** @type {number} */ copy) => {
    const material = /** @type {import("../vendor/three.js").MeshLambertMaterial} */ (part.material);
    const isFlat = part.material instanceof MeshBasicMaterial;
    const paints = material.vertexColors ? part.geometry.getAttribute("color") : undefined;
    placed.identity();
    tint.copy(material.map ? new Color("#222222") : material.color);
    if (part instanceof InstancedMesh) {
      part.getMatrixAt(copy, placed);
      if (part.instanceColor) part.getColorAt(copy, tint);
    }
    placed.premultiply(part.matrixWorld);
    const places = part.geometry.getAttribute("position");
    const order = part.geometry.index;
    const { start, count } = part.geometry.drawRange;
    const end = Math.min(order ? order.count : places.count, start + count);
    for (let i = start; i + 2 < end; i += 3) {
      const corners = [a, b, c].map((corner, k) => corner.fromBufferAttribute(places, order ? order.getX(i + k) : i + k).applyMatrix4(placed));
      normal.subVectors(b, a).cross(c.clone().sub(a)).normalize();
      const faces = normal.dot(camera.position.clone().sub(a));
      if (faces === 0 || (faces < 0 && material.side !== DoubleSide)) continue;
      if (faces < 0) normal.negate();
      if (paints) tint.fromBufferAttribute(paints, i);
      add(corners, isFlat ? 1 : 0.42 + 0.58 * Math.max(normal.dot(light), 0), material.opacity);
    }
  };
  const addLines = (/** @type {LineSegments} */ part) => {
    const { color, opacity } = /** @type {import("../vendor/three.js").LineBasicMaterial} */ (part.material);
    tint.copy(color);
    const places = part.geometry.getAttribute("position");
    for (let i = 0; i + 1 < places.count; i += 2) {
      const [from, to] = [new Vector3(), new Vector3()].map((end, k) => end.fromBufferAttribute(places, i + k).applyMatrix4(part.matrixWorld));
      const count = Math.max(Math.ceil(from.distanceTo(to) / PIECE), 1);
      // A line on a surface is seen.
      for (let k = 0; k < count; k += 1) add([a.lerpVectors(from, to, k / count), b.lerpVectors(from, to, (k + 1) / count)], 1, opacity, 0.99);
    }
  };
  scene.traverseVisible((part) => {
    if (part === without) return;
    if (part instanceof LineSegments) addLines(part);
    if (part instanceof Line || !(part instanceof Mesh) || part.material instanceof ShadowMaterial) return;
    for (let copy = 0; copy < (part instanceof InstancedMesh ? part.count : 1); copy += 1) addMesh(part, copy);
  });
  return facets;
}
