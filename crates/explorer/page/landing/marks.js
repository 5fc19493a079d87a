import {
  BufferGeometry, CanvasTexture, CatmullRomCurve3, Group, Line, LineBasicMaterial, Mesh, MeshBasicMaterial, SphereGeometry,
  SRGBColorSpace, TubeGeometry, Vector3,
} from "../vendor/three.js";
import { colours } from "../look/theme.js";
import { Rods, span, triangle } from "./shapes.js";

/** @typedef {import("./materials.js").Materials} Materials */

const foot = new Vector3();

/** The CG with its path and its plumb line, the polygon of the feet and the critical edge that the vehicle would topple over. */
export class Marks {
  /** @param {Materials} materials @param {number} size of the lander, ft @param {number} legs how many */
  constructor(materials, size, legs) {
    this.group = new Group();
    this.materials = materials;
    this.size = size;
    const ball = new SphereGeometry(0.024 * size, 24, 16);
    this.ball = new Mesh(ball, new MeshBasicMaterial({ map: quarters(), depthTest: false, transparent: true, fog: false }));
    this.ball.renderOrder = 5;
    // The sides of the polygon, then the plumb line and the critical edge.
    this.rods = new Rods(materials.marks, legs + 2);
    for (let leg = 0; leg < legs; leg += 1) this.rods.setColorAt(leg, materials.polygon);
    this.rods.setColorAt(legs, materials.path.color);
    this.rods.setColorAt(legs + 1, materials.critical);
    this.leaning = triangle(materials.leaning);
    this.path = new Group();
    this.group.add(this.path, this.ball, this.rods, this.leaning);
  }

  /** @param {import("./motion.js").Motion} motion */
  set(motion) {
    this.#drawPath(motion.drawing.instants.center_of_gravity);
    this.ring = motion.drawing.vehicle.ring;
    const { surface_point, normal } = motion.drawing.ground;
    this.surface = { point: new Vector3(...surface_point), normal: new Vector3(...normal) };
  }

  /** @param {import("../engine/types.js").Vector[]} places */
  #drawPath(places) {
    for (const part of [...this.path.children]) {
      /** @type {Mesh | Line} */ (part).geometry.dispose();
      part.removeFromParent();
    }
    const every = Math.max(1, Math.floor(places.length / 240));
    const points = places.filter((_, index) => index % every === 0 || index === places.length - 1).map((p) => new Vector3(...p));
    if (points.length < 2 || points[0].distanceTo(points[points.length - 1]) < 1e-6) return;
    const ahead = new LineBasicMaterial({ color: colours().scene.path, transparent: true, opacity: 0.55 });
    this.path.add(new Line(new BufferGeometry().setFromPoints(points), ahead));
    this.segments = points.length - 1;
    const curve = new CatmullRomCurve3(points, false, "chordal");
    // Places of the curve go with its points, so that its drawn part goes with time.
    curve.getPointAt = (u, target) => curve.getPoint(u, target);
    this.done = new Mesh(new TubeGeometry(curve, this.segments, 0.006 * this.size, 6), this.materials.path);
    this.path.add(this.done);
  }

  /** @param {import("./motion.js").Pose} pose @param {number} share of the instants that have passed */
  place(pose, share) {
    this.ball.position.copy(pose.center);
    this.ball.quaternion.copy(pose.rotation);
    this.done?.geometry.setDrawRange(0, 36 * Math.round(share * (this.segments ?? 0)));
    if (!this.surface || !this.ring) return;
    const count = this.ring.length;
    const corners = this.ring.map((leg) => pose.legs[leg - 1].pivot);
    for (const [index, corner] of corners.entries()) {
      this.rods.lay(index, 0.004 * this.size, corner, corners[(index + 1) % count]);
    }
    const edge = pose.criticalEdge;
    const [a, b] = edge ? edge.map((leg) => pose.legs[leg - 1].pivot) : [foot, foot];
    this.rods.lay(count + 1, 0.009 * this.size, a, b);
    this.leaning.visible = edge !== null;
    if (edge) span(this.leaning, pose.center, a, b);
    // Straight down to the surface.
    const { point, normal } = this.surface;
    const height = foot.subVectors(pose.center, point).dot(normal) / -normal.z;
    foot.copy(pose.center);
    foot.z += Math.max(height, 0);
    this.rods.lay(count, 0.003 * this.size, pose.center, foot);
  }
}

/** The mark of a centre of gravity: quarters in black and white. */
function quarters() {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  for (let column = 0; column < 4; column += 1) {
    for (let row = 0; row < 2; row += 1) {
      context.fillStyle = (row + column) % 2 ? "#111111" : "#ffffff";
      context.fillRect(column * 16, row * 32, 16, 32);
    }
  }
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  return texture;
}
