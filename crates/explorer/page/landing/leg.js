import { Group, MeshStandardMaterial, Vector3 } from "../vendor/three.js";
import { Footpad } from "./footpad.js";
import { lay, rod } from "./shapes.js";

/** @typedef {import("./materials.js").Materials} Materials */
/** @typedef {import("./motion.js").LegPose} LegPose */
/** @typedef {import("./motion.js").Pose} Pose */

/** Part of the extended strut that its sleeve takes. */
const SLEEVE = 0.6;
const [upper, hinge, foot, outboard, joint] = [0, 1, 2, 3, 4].map(() => new Vector3());

/** A leg: the lower link as a fork, the strut with its rod in its sleeve, and the footpad. */
export class Leg {
  /** @param {import("../engine/types.js").LegShape} shape @param {Materials} materials @param {number} size of the lander, ft */
  constructor(shape, materials, size) {
    this.shape = shape;
    this.materials = materials;
    this.group = new Group();
    this.forks = [rod(0.0085 * size, materials.metal), rod(0.0085 * size, materials.metal)];
    this.sleeveMaterial = /** @type {MeshStandardMaterial} */ (materials.sleeve.clone());
    this.sleeve = rod(0.017 * size, this.sleeveMaterial);
    this.rod = rod(0.01 * size, materials.rod);
    this.pad = new Footpad(shape.footpad, materials);
    this.group.add(...this.forks, this.sleeve, this.rod, this.pad.group);
    const [x, y] = shape.outboard;
    this.outboard = new Vector3(x, y, 0);
    this.sideways = new Vector3(y, -x, 0).multiplyScalar(0.06 * size);
    this.upper = new Vector3(...shape.upper_hardpoint);
    this.lower = new Vector3(...shape.lower_hardpoint);
  }

  /** @param {Pose} pose @param {LegPose} leg */
  place(pose, leg) {
    const toGround = (/** @type {Vector3} */ into, /** @type {Vector3} */ point) =>
      into.copy(point).applyQuaternion(pose.rotation).add(pose.center);
    toGround(upper, this.upper);
    foot.copy(leg.pivot);
    for (const [index, mesh] of this.forks.entries()) {
      hinge.copy(this.lower).addScaledVector(this.sideways, index === 0 ? 1 : -1);
      lay(mesh, toGround(hinge, hinge), foot);
    }
    const { extended_length, minimum_length } = this.shape.strut;
    const length = upper.distanceTo(foot);
    joint.copy(upper).lerp(foot, Math.min((SLEEVE * extended_length) / length, 0.97));
    lay(this.sleeve, upper, joint);
    lay(this.rod, joint, foot);
    const share = Math.min(Math.max(leg.stroke / Math.max(extended_length - minimum_length, 1e-9), 0), 1);
    this.sleeveMaterial.color.copy(this.materials.sleeve.color).lerp(this.materials.stroked, share);
    outboard.copy(this.outboard).applyQuaternion(pose.rotation);
    this.pad.place(foot, leg.padAxis, outboard, leg.padCrush);
  }
}
