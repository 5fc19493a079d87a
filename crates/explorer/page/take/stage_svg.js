import { Color, InstancedMesh, LineSegments, Line, Matrix4, Mesh, MeshBasicMaterial, ShadowMaterial, Sprite, Vector3 } from "../vendor/three.js";
import { colours } from "../look/theme.js";
import { SvgContext } from "./svg_context.js";

/** @typedef {import("../landing/stage.js").Stage} Stage */
/** @typedef {{ depth: number, points: [number, number][], colour: string, opacity: number }} Facet */

const placed = new Matrix4();
const tint = new Color();
const [a, b, c, normal] = [0, 1, 2, 3].map(() => new Vector3());
/** Lines of the grid to either side, ft. */
const REACH = 40;

/**
 * What a stage shows, as SVG: facets from back to front over the grid of the ground.
 * @param {Stage} stage
 * @param {Mesh} ground the surface, of which only the grid is drawn
 * @param {number} step of the grid, ft
 */
export function stageSvg(stage, ground, step) {
  const { clientWidth: width, clientHeight: height } = stage.canvas;
  const svg = new SvgContext(width, height);
  const { camera } = stage;
  stage.scene.updateMatrixWorld();
  svg.fillStyle = colours().scene.sky;
  svg.fillRect(0, 0, width, height);
  const project = (/** @type {Vector3} */ point) => {
    point.project(camera);
    return /** @type {[number, number]} */ ([(0.5 + 0.5 * point.x) * width, (0.5 - 0.5 * point.y) * height]);
  };
  drawGround(svg, stage, ground, step, project);
  const facets = facetsOf(stage, ground, project);
  facets.sort((one, other) => other.depth - one.depth);
  for (const { points, colour, opacity } of facets) {
    svg.beginPath();
    points.forEach(([x, y], index) => (index ? svg.lineTo(x, y) : svg.moveTo(x, y)));
    svg.fillStyle = svg.strokeStyle = colour;
    svg.lineWidth = 0.4;
    svg.globalAlpha = opacity;
    if (points.length > 2) {
      svg.closePath();
      svg.fill();
    }
    if (opacity === 1) svg.stroke();
  }
  drawWords(svg, stage, project);
  return svg.toString();
}

/** @param {SvgContext} svg @param {Stage} stage @param {(point: Vector3) => [number, number]} project */
function drawWords(svg, stage, project) {
  svg.globalAlpha = 1;
  svg.font = "13px";
  svg.textAlign = "center";
  stage.scene.traverseVisible((part) => {
    if (!(part instanceof Sprite)) return;
    svg.fillStyle = part.userData.colour;
    svg.fillText(part.userData.text, ...project(part.getWorldPosition(a)));
  });
}

/** @param {SvgContext} svg @param {Stage} stage @param {Mesh} ground @param {number} step @param {(point: Vector3) => [number, number]} project */
function drawGround(svg, stage, ground, step, project) {
  const { position } = stage.camera;
  const isBefore = (/** @type {Vector3} */ point) => normal.subVectors(point, position).dot(stage.camera.getWorldDirection(c)) > 0.5;
  const corner = (/** @type {number} */ x, /** @type {number} */ y) => new Vector3(x, y, 0).applyMatrix4(ground.matrixWorld);
  svg.fillStyle = svg.strokeStyle = colours().scene.ground;
  const tile = REACH / 8;
  for (let x = -REACH; x < REACH; x += tile) {
    for (let y = -REACH; y < REACH; y += tile) {
      const corners = [corner(x, y), corner(x + tile, y), corner(x + tile, y + tile), corner(x, y + tile)];
      if (!corners.every(isBefore)) continue;
      svg.beginPath();
      corners.map(project).forEach((place, index) => (index ? svg.lineTo(...place) : svg.moveTo(...place)));
      svg.closePath();
      svg.fill();
      svg.stroke();
    }
  }
  svg.strokeStyle = colours().scene.gridLine;
  const count = Math.floor(REACH / step);
  for (const isAcross of [false, true]) {
    for (let line = -count; line <= count; line += 1) {
      svg.beginPath();
      let isOpen = true;
      for (let piece = -count; piece <= count; piece += 1) {
        a.set(isAcross ? piece * step : line * step, isAcross ? line * step : piece * step, 0).applyMatrix4(ground.matrixWorld);
        if (!isBefore(a)) {
          isOpen = true;
          continue;
        }
        const [x, y] = project(a);
        if (isOpen) svg.moveTo(x, y);
        else svg.lineTo(x, y);
        isOpen = false;
      }
      svg.lineWidth = line % 5 === 0 ? 1 : 0.5;
      svg.globalAlpha = 0.5;
      svg.stroke();
    }
  }
}

/** @param {Stage} stage @param {Mesh} ground @param {(point: Vector3) => [number, number]} project @returns {Facet[]} */
function facetsOf(stage, ground, project) {
  /** @type {Facet[]} */
  const facets = [];
  const light = stage.sun.position.clone().sub(stage.sun.target.position).normalize();
  const addFacets = (/** @type {Mesh} */ part, /** @type {number} */ copy) => {
    const material = /** @type {import("../vendor/three.js").MeshLambertMaterial} */ (part.material);
    const isFlat = part.material instanceof MeshBasicMaterial;
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
      const faces = normal.dot(stage.camera.position.clone().sub(a));
      if (faces === 0 || (faces < 0 && !isFlat)) continue;
      const shade = isFlat ? 1 : 0.42 + 0.58 * Math.max(normal.dot(light), 0);
      const colour = tint.clone().convertLinearToSRGB();
      const depth = corners.reduce((sum, corner) => sum + corner.distanceTo(stage.camera.position), 0) / 3;
      const points = corners.map((corner) => project(corner));
      const rgb = [colour.r, colour.g, colour.b].map((value) => Math.round(255 * Math.min(value * shade, 1)).toString(16).padStart(2, "0"));
      facets.push({ depth, points, colour: `#${rgb.join("")}`, opacity: material.opacity });
    }
  };
  stage.scene.traverseVisible((part) => {
    if (part === ground || part instanceof Sprite || part instanceof LineSegments || part instanceof Line) return;
    if (!(part instanceof Mesh) || part.material instanceof ShadowMaterial) return;
    for (let copy = 0; copy < (part instanceof InstancedMesh ? part.count : 1); copy += 1) addFacets(part, copy);
  });
  return facets;
}
