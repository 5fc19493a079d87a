import {
  BoxGeometry, Color, CylinderGeometry, Group, IcosahedronGeometry, Matrix4, Mesh, Vector3,
} from "../vendor/three.js";
import { Copies, Rods } from "./shapes.js";

/** @typedef {import("./materials.js").Materials} Materials */
/** @typedef {import("../engine/types.js").VehicleShape} VehicleShape */

/** Vehicle axes have z down and three's cylinders lie along y. @param {Mesh} mesh */
function upright(mesh) {
  mesh.rotation.x = -Math.PI / 2;
  mesh.castShadow = true;
  return mesh;
}

/** A block of honeycomb, its height along z. */
const BLOCK = new CylinderGeometry(1, 1, 1, 22).rotateX(-Math.PI / 2);
const at = new Vector3();
const placed = new Matrix4();
const colour = new Color();

/** The body: a frame through the hardpoints, a bus and a mast inside it, and blocks that crush under it. For drawing only. */
export class Body {
  /** @param {VehicleShape} shape @param {Materials} materials @param {number} size of the lander, ft */
  constructor(shape, materials, size) {
    this.group = new Group();
    this.materials = materials;
    const uppers = shape.legs.map((leg) => new Vector3(...leg.upper_hardpoint));
    const lowers = shape.legs.map((leg) => new Vector3(...leg.lower_hardpoint));
    const [cx, cy] = shape.center;
    const deck = mean(lowers.map((point) => point.z));
    const top = Math.min(...uppers.map((point) => point.z), deck - 0.1 * size);
    const beam = 0.008 * size;
    const frame = new Rods(materials.metal, shape.legs.reduce((count, leg) => count + 6 + leg.struts.length, 1));
    let laid = 0;
    const add = (/** @type {Vector3} */ from, /** @type {Vector3} */ to, thickness = beam) => frame.lay(laid++, thickness, from, to);
    for (const [index, lower] of lowers.entries()) {
      const next = (index + 1) % lowers.length;
      add(lower, lowers[next]);
      add(uppers[index], uppers[next]);
      add(lower, uppers[index]);
      add(lower, uppers[next], 0.7 * beam);
      add(uppers[index], lowers[next], 0.7 * beam);
      add(lower, new Vector3(cx, cy, deck));
      for (const strut of shape.legs[index].struts) {
        at.set(...strut.from);
        add(at, at.distanceTo(lower) < at.distanceTo(uppers[index]) ? lower : uppers[index]);
      }
    }
    const inner = 0.5 * mean(lowers.map((point) => Math.hypot(point.x - cx, point.y - cy)));
    const sides = 2 * shape.legs.length;
    // Twice the height of the CG over the deck, at least that of the hardpoints.
    const roof = Math.min(top, -0.55 * deck);
    const bus = upright(new Mesh(new CylinderGeometry(0.82 * inner, inner, deck - roof, sides), materials.foil));
    bus.position.set(cx, cy, 0.5 * (deck + roof));
    const lid = upright(new Mesh(new CylinderGeometry(0.6 * inner, 0.82 * inner, 0.12 * inner, sides), materials.white));
    lid.position.set(cx, cy, roof - 0.06 * inner);
    const nozzle = upright(new Mesh(new CylinderGeometry(0.2 * inner, 0.4 * inner, 0.3 * inner, 20, 1, true), materials.dark));
    nozzle.position.set(cx, cy, deck + 0.15 * inner);
    const tanks = new Copies(new IcosahedronGeometry(0.26 * inner, 2), materials.white, lowers.length);
    for (const [index, lower] of lowers.entries()) {
      const next = lowers[(index + 1) % lowers.length];
      at.copy(lower).add(next).multiplyScalar(0.5);
      at.set(at.x + 0.35 * (cx - at.x), at.y + 0.35 * (cy - at.y), deck - 0.2 * inner);
      tanks.setMatrixAt(index, placed.makeTranslation(at));
    }
    const mast = new Vector3(cx, cy, roof - 1.1 * inner);
    add(new Vector3(cx, cy, roof), mast, 0.9 * beam);
    const plate = new Mesh(new BoxGeometry(1.15 * inner, 0.8 * inner, 0.04 * inner), materials.panel);
    plate.position.set(cx + 0.3 * inner, cy, mast.z);
    plate.rotation.y = -0.35;
    plate.castShadow = true;
    this.blocks = shape.legs.map(({ block }) => block);
    this.honeycomb = new Copies(BLOCK, materials.copies, this.blocks.length);
    this.group.add(frame, bus, lid, nozzle, tanks, plate, this.honeycomb);
  }

  /** @param {import("./motion.js").Pose} pose */
  place(pose) {
    this.group.position.copy(pose.center);
    this.group.quaternion.copy(pose.rotation);
    for (const [index, block] of this.blocks.entries()) {
      const crush = Math.max(pose.legs[index].blockCrush, 0);
      const height = Math.max(Math.abs(block?.height ?? 0), 0.05);
      const left = Math.max(height - crush, 0.08 * height);
      const radius = 0.5 * (block?.diameter ?? 0);
      placed.makeScale(radius, radius, left);
      if (block) placed.setPosition(block.face[0], block.face[1], block.face[2] - height + 0.5 * left);
      this.honeycomb.setMatrixAt(index, placed);
      const share = Math.min(crush / (0.5 * height), 1);
      this.honeycomb.setColorAt(index, colour.copy(this.materials.honeycomb.color).lerp(this.materials.crushed, share));
    }
  }
}

/** @param {number[]} values */
const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;
