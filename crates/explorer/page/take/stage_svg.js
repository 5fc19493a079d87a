import { Vector3 } from "../vendor/three.js";
import { colours } from "../look/theme.js";
import { sceneSvg } from "./scene_svg.js";

/** @typedef {import("../landing/stage.js").Stage} Stage */
/** @typedef {import("../vendor/three.js").Mesh} Mesh */
/** @typedef {import("./svg_context.js").SvgContext} SvgContext */

const [a, c, normal] = [0, 1, 2].map(() => new Vector3());
/** Lines of the grid to either side, ft. */
const REACH = 40;

/**
 * What a stage shows, as SVG, over the grid of the ground.
 * @param {Stage} stage
 * @param {Mesh} ground the surface, of which only the grid is drawn
 * @param {number} step of the grid, ft
 */
export function stageSvg(stage, ground, step) {
  const { scene, camera, sun } = stage;
  return sceneSvg({
    scene,
    camera,
    light: sun.position.clone().sub(sun.target.position).normalize(),
    size: [stage.canvas.clientWidth, stage.canvas.clientHeight],
    paper: colours().scene.sky,
    below: (svg, project) => drawGround(svg, stage, ground, step, project),
    without: ground,
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
