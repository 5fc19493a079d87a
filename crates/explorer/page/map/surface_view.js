import {
  BufferGeometry, Color, Float32BufferAttribute, Group, LineBasicMaterial, LineSegments, Mesh, MeshLambertMaterial, AmbientLight,
  DirectionalLight, DoubleSide, OrbitControls, PerspectiveCamera, Raycaster, Scene, Vector2, WebGLRenderer, MeshBasicMaterial, SphereGeometry,
} from "../vendor/three.js";
import { Label } from "../landing/shapes.js";
import { sharpness } from "../landing/sharpness.js";
import { element } from "../look/elements.js";
import { colours, onTheme } from "../look/theme.js";
import { label, roundStep, roundValues } from "../look/words.js";
import { band, bandsOf, pieces, trianglesOf } from "./triangles.js";
import { nearestPoint, viewOf } from "./view.js";

/** @typedef {import("../engine/types.js").MapAnswer} MapAnswer */
/** @typedef {import("../engine/types.js").MapPoint} MapPoint */

/** Height of the box, its sides being 2. */
const HEIGHT = 1;

/** The stability surface in three dimensions, to be turned by pointer. Gaps stay gaps; lines join the two heights of a jump. */
export class SurfaceView {
  /** @param {(point: MapPoint) => void} onChoose */
  constructor(onChoose) {
    this.canvas = element("canvas", { role: "img", tabindex: 0, "aria-label": "The surface of V_H in three dimensions" });
    this.root = element("div", { class: "surface" }, this.canvas);
    this.renderer = new WebGLRenderer({ canvas: this.canvas, antialias: sharpness().smooths });
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(30, 1, 0.05, 50);
    this.camera.position.set(-2.9, 3.1, 4.8);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.target.set(0, 0.25, 0);
    this.controls.listenToKeyEvents(this.canvas);
    this.controls.addEventListener("change", () => this.draw());
    this.sun = new DirectionalLight(0xffffff, 1.9);
    this.sun.position.set(-2, 4, 2.5);
    this.scene.add(new AmbientLight(0xffffff, 1.7), this.sun);
    this.content = new Group();
    this.scene.add(this.content);
    this.mark = new Mesh(new SphereGeometry(0.035, 16, 12), new MeshBasicMaterial({ depthTest: false, transparent: true }));
    this.mark.renderOrder = 5;
    this.mark.visible = false;
    this.scene.add(this.mark);
    new ResizeObserver(() => this.#fit()).observe(this.root);
    onTheme(() => this.map && this.set(this.map));
    let pressed = [0, 0];
    this.canvas.addEventListener("pointerdown", (event) => (pressed = [event.clientX, event.clientY]));
    this.canvas.addEventListener("click", (event) => {
      if (Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4) return;
      const point = this.#pick(event);
      if (point) onChoose(point);
    });
  }

  #fit() {
    const { clientWidth, clientHeight } = this.root;
    if (clientWidth < 2 || clientHeight < 2) return;
    this.renderer.setPixelRatio(sharpness().still);
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  draw() {
    if (this.isWanted) return;
    this.isWanted = true;
    requestAnimationFrame(() => {
      this.isWanted = false;
      this.renderer.render(this.scene, this.camera);
    });
  }

  /** @param {MapAnswer} map */
  set(map) {
    this.map = map;
    this.content.traverse((part) => {
      if (part instanceof Mesh || part instanceof LineSegments) part.geometry.dispose();
    });
    this.content.clear();
    this.scene.background = new Color(colours().paper);
    const triangles = trianglesOf(map);
    const speeds = triangles.flat().map((corner) => corner[2]);
    if (speeds.length === 0) return this.draw();
    const step = roundStep((speeds.reduce((a, b) => Math.max(a, b)) - speeds.reduce((a, b) => Math.min(a, b))) / 8);
    const floor = step * Math.floor(speeds.reduce((a, b) => Math.min(a, b)) / step);
    const top = Math.max(step * Math.ceil(speeds.reduce((a, b) => Math.max(a, b)) / step), floor + step);
    const view = viewOf(map);
    this.at = (slow, fast, speed) => {
      const { up, across } = view.at(slow, fast);
      return [2 * across - 1, (HEIGHT * (speed - floor)) / (top - floor), 1 - 2 * up];
    };
    this.#surface(map, triangles);
    this.#jumps(map);
    this.#gaps(map, floor);
    this.#box(map, view, { floor, top, step });
    this.draw();
  }

  /** @type {(slow: number, fast: number, speed: number) => [number, number, number]} */
  at = () => [0, 0, 0];

  /** @param {MapAnswer} map @param {import("./triangles.js").Triangle[]} triangles */
  #surface(map, triangles) {
    const places = [];
    const paints = [];
    const lines = [];
    for (const { low, high, colour } of bandsOf(map.levels)) {
      const { r, g, b } = new Color(colour);
      for (const polygon of band(triangles, low, high)) {
        for (let i = 1; i + 1 < polygon.length; i += 1) {
          for (const corner of [polygon[0], polygon[i], polygon[i + 1]]) {
            places.push(...this.at(...corner));
            paints.push(r, g, b);
          }
        }
      }
      if (Number.isFinite(high)) {
        for (const piece of pieces(triangles, high)) for (const corner of piece) lines.push(...this.at(...corner));
      }
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new Float32BufferAttribute(places, 3));
    geometry.setAttribute("color", new Float32BufferAttribute(paints, 3));
    geometry.computeVertexNormals();
    const material = new MeshLambertMaterial({ vertexColors: true, side: DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
    this.surface = new Mesh(geometry, material);
    this.content.add(this.surface, this.#segments(lines, "#262626", 0.85));
  }

  /** Lines between neighbours that belong to different kinds of motion. @param {MapAnswer} map */
  #jumps(map) {
    if (!map.grid || map.jump === null) return;
    const [{ values: slow }, { values: fast }] = map.axes;
    const { speeds } = map.grid;
    const lines = [];
    for (let row = 0; row < slow.length; row += 1) {
      for (let column = 0; column < fast.length; column += 1) {
        for (const [r, c] of [[row + 1, column], [row, column + 1]]) {
          const [here, there] = [speeds[row][column], speeds[r]?.[c] ?? null];
          if (here === null || there === null || Math.abs(here - there) <= map.jump) continue;
          lines.push(...this.at(slow[row], fast[column], here), ...this.at(slow[r], fast[c], there));
        }
      }
    }
    this.content.add(this.#segments(lines, colours().jump, 0.7));
  }

  /** Marks on the floor where there is no transition. @param {MapAnswer} map @param {number} floor */
  #gaps(map, floor) {
    const lines = [];
    const side = 0.6 / Math.max(...map.axes.map(({ values }) => values.length), 12);
    for (const { place, to } of map.points) {
      if (to !== null || !map.grid) continue;
      const [x, y, z] = this.at(place[0], place[1], floor);
      const ring = [[x, z - side], [x + side, z + 0.75 * side], [x - side, z + 0.75 * side]];
      for (let i = 0; i < 3; i += 1) lines.push(ring[i][0], y, ring[i][1], ring[(i + 1) % 3][0], y, ring[(i + 1) % 3][1]);
    }
    for (const edge of map.edges) {
      for (let i = 1; i < edge.places.length; i += 1) {
        for (const [slow, fast] of [edge.places[i - 1], edge.places[i]]) lines.push(...this.at(slow, fast, floor));
      }
    }
    this.content.add(this.#segments(lines, colours().stable, 1));
  }

  /**
   * @param {MapAnswer} map
   * @param {ReturnType<typeof viewOf>} view
   * @param {{ floor: number, top: number, step: number }} heights
   */
  #box(map, view, { floor, top, step }) {
    const lines = [];
    const { text, paper, grid } = colours();
    const write = (/** @type {string} */ words, /** @type {[number, number, number]} */ place, size = 0.055) => {
      const made = new Label(size);
      made.write(words, text, paper);
      made.sprite.position.set(...place);
      this.content.add(made.sprite);
    };
    const { slowEnds, fastEnds } = view;
    for (const slow of roundValues(slowEnds.low, slowEnds.high, 6)) {
      const [, , z] = this.at(slow, fastEnds.low, floor);
      lines.push(-1, 0, z, 1, 0, z, 1, 0, z, 1, HEIGHT, z);
      write(label(slow), [-1.12, 0, z]);
    }
    for (const fast of roundValues(fastEnds.low, fastEnds.high, 6)) {
      const [x] = this.at(slowEnds.low, fast, floor);
      lines.push(x, 0, -1, x, 0, 1, x, 0, -1, x, HEIGHT, -1);
      write(label(fast), [x, 0, 1.12]);
    }
    for (let speed = floor; speed <= top + 1e-9; speed += step) {
      const y = (HEIGHT * (speed - floor)) / (top - floor);
      lines.push(-1, y, -1, 1, y, -1, 1, y, -1, 1, y, 1);
      // At the floor stands the first value of an axis.
      if (speed > floor) write(label(speed), [-1.08, y, -1]);
    }
    write(`V_H, ${map.speed_unit}`, [-1.05, HEIGHT + 0.12, -1], 0.065);
    write(map.axes[0].title, [-1.35, -0.36, 0.5], 0.065);
    write(map.axes[1].title, [0, -0.2, 1.34], 0.065);
    this.content.add(this.#segments(lines, grid, 1));
  }

  /** @param {number[]} places @param {string} color @param {number} opacity */
  #segments(places, color, opacity) {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new Float32BufferAttribute(places, 3));
    return new LineSegments(geometry, new LineBasicMaterial({ color, opacity, transparent: opacity < 1 }));
  }

  /** @param {MouseEvent} event */
  #pick(event) {
    if (!this.map || !this.surface) return undefined;
    const box = this.canvas.getBoundingClientRect();
    const where = new Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2);
    const ray = new Raycaster();
    ray.setFromCamera(where, this.camera);
    const [hit] = ray.intersectObject(this.surface);
    if (!hit) return undefined;
    const { slow, fast } = viewOf(this.map).placeOf(0.5 * (1 - hit.point.z), 0.5 * (hit.point.x + 1));
    return nearestPoint(this.map, slow, fast);
  }

  /** Marks a point. @param {MapPoint | undefined} point */
  choose(point) {
    this.mark.visible = point !== undefined && point.speed !== null;
    if (point && point.speed !== null) this.mark.position.set(...this.at(point.place[0], point.place[1], point.speed));
    /** @type {MeshBasicMaterial} */ (this.mark.material).color.set(colours().jump);
    this.draw();
  }
}
