import { CylinderGeometry, Group, LatheGeometry, Matrix4, Mesh, Vector2, Vector3 } from "../vendor/three.js";

/** @typedef {import("./materials.js").Materials} Materials */

/** Part of the height of a pad above which it is rigid. */
const RIGID = 0.34;
const across = new Vector3();
const outboard = new Vector3();
const basis = new Matrix4();

/** A footpad: a rigid cap on the pivot and honeycomb below it that crushes on either half. */
export class Footpad {
  /** @param {{ diameter: number, height: number }} shape @param {Materials} materials */
  constructor(shape, materials) {
    this.shape = shape;
    this.group = new Group();
    const [r, h] = [0.5 * shape.diameter, shape.height];
    // Local axes: y along the axis of the pad, down to its face; z outboard.
    const cap = [[0, -0.16 * h], [0.2 * r, -0.14 * h], [0.34 * r, 0], [0.8 * r, 0.22 * h], [r, RIGID * h]];
    const profile = cap.map(([x, y]) => new Vector2(x, y)).reverse();
    const rigid = new Mesh(new LatheGeometry(profile, 28), materials.metal);
    this.comb = new Mesh(new CylinderGeometry(1, 1, 1, 28, 1), materials.honeycomb.clone());
    this.uncrushed = this.comb.geometry.getAttribute("position").clone();
    for (const mesh of [rigid, this.comb]) {
      mesh.castShadow = true;
      this.group.add(mesh);
    }
    this.materials = materials;
    this.pressed = [-1, -1];
  }

  /**
   * @param {Vector3} pivot
   * @param {Vector3} axis unit vector from the pivot to the face
   * @param {Vector3} legOutboard outboard direction of the leg
   * @param {[number, number]} crush of the outboard and of the inboard half, ft
   */
  place(pivot, axis, legOutboard, crush) {
    outboard.copy(legOutboard).addScaledVector(axis, -legOutboard.dot(axis)).normalize();
    across.crossVectors(axis, outboard);
    this.group.matrixAutoUpdate = false;
    this.group.matrix.copy(basis.makeBasis(across, axis, outboard).setPosition(pivot));
    this.group.matrixWorldNeedsUpdate = true;
    if (crush[0] !== this.pressed[0] || crush[1] !== this.pressed[1]) this.press(crush);
  }

  /** @param {[number, number]} crush */
  press(crush) {
    this.pressed = [...crush];
    const [r, h] = [0.5 * this.shape.diameter, this.shape.height];
    const [mean, slope] = [0.5 * (crush[0] + crush[1]), (crush[0] - crush[1]) / (0.4244 * this.shape.diameter)];
    const position = this.comb.geometry.getAttribute("position");
    for (let i = 0; i < position.count; i += 1) {
      const [x, y, z] = [this.uncrushed.getX(i) * r, this.uncrushed.getY(i), this.uncrushed.getZ(i) * r];
      const face = h - Math.max(mean + slope * z, 0);
      position.setXYZ(i, x, y > 0 ? Math.max(face, (RIGID + 0.04) * h) : RIGID * h, z);
    }
    position.needsUpdate = true;
    this.comb.geometry.computeVertexNormals();
    const share = Math.min(Math.max(crush[0], crush[1], 0) / (0.3 * h), 1);
    /** @type {import("../vendor/three.js").MeshLambertMaterial} */ (this.comb.material).color
      .copy(this.materials.honeycomb.color)
      .lerp(this.materials.crushed, share);
  }
}
