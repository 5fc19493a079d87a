import { Color, Group, Vector3 } from "../vendor/three.js";
import { Footpad } from "./footpad.js";
import { Rods } from "./shapes.js";

/** @typedef {import("./materials.js").Materials} Materials */
/** @typedef {import("./motion.js").Pose} Pose */

/** Part of the extended strut that its sleeve takes. */
const SLEEVE = 0.6;
/** Rods of a leg: two of its fork, sleeve and rod of its strut. */
const RODS = 4;
const [upper, hinge, foot, outboard, joint] = [0, 1, 2, 3, 4].map(() => new Vector3());
const colour = new Color();

/** The legs: of each the lower link as a fork, the strut with its rod in its sleeve, and the footpad. */
export class Legs {
  /** @param {import("../engine/types.js").LegShape[]} shapes @param {Materials} materials @param {number} size of the lander, ft */
  constructor(shapes, materials, size) {
    this.materials = materials;
    this.size = size;
    this.rods = new Rods(materials.copies, RODS * shapes.length);
    this.legs = shapes.map((shape, index) => {
      const { metal, sleeve, rod } = materials;
      [metal.color, metal.color, sleeve, rod].forEach((is, number) => this.rods.setColorAt(RODS * index + number, is));
      const [x, y] = shape.outboard;
      return {
        strut: shape.strut,
        pad: new Footpad(shape.footpad, materials),
        outboard: new Vector3(x, y, 0),
        sideways: new Vector3(y, -x, 0).multiplyScalar(0.06 * size),
        upper: new Vector3(...shape.upper_hardpoint),
        lower: new Vector3(...shape.lower_hardpoint),
      };
    });
    this.group = new Group();
    this.group.add(this.rods, ...this.legs.map(({ pad }) => pad.group));
  }

  /** @param {Pose} pose */
  place(pose) {
    const toGround = (/** @type {Vector3} */ into, /** @type {Vector3} */ point) =>
      into.copy(point).applyQuaternion(pose.rotation).add(pose.center);
    for (const [index, leg] of this.legs.entries()) {
      const { pivot, padAxis, padCrush, stroke } = pose.legs[index];
      const first = RODS * index;
      toGround(upper, leg.upper);
      foot.copy(pivot);
      for (const side of [0, 1]) {
        hinge.copy(leg.lower).addScaledVector(leg.sideways, side === 0 ? 1 : -1);
        this.rods.lay(first + side, 0.0085 * this.size, toGround(hinge, hinge), foot);
      }
      const { extended_length, minimum_length } = leg.strut;
      joint.copy(upper).lerp(foot, Math.min((SLEEVE * extended_length) / upper.distanceTo(foot), 0.97));
      this.rods.lay(first + 2, 0.017 * this.size, upper, joint);
      this.rods.lay(first + 3, 0.01 * this.size, joint, foot);
      const share = Math.min(Math.max(stroke / Math.max(extended_length - minimum_length, 1e-9), 0), 1);
      this.rods.setColorAt(first + 2, colour.copy(this.materials.sleeve).lerp(this.materials.stroked, share));
      leg.pad.place(foot, padAxis, outboard.copy(leg.outboard).applyQuaternion(pose.rotation), padCrush);
    }
  }
}
