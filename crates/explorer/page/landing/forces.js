import { Group, Vector3 } from "../vendor/three.js";
import { roundStep } from "../look/words.js";
import { Arrow } from "./shapes.js";

/** @typedef {import("./materials.js").Materials} Materials */

const vector = new Vector3();
const at = new Vector3();

/** Forces of the ground on pads and blocks. */
export class Forces {
  /** @param {Materials} materials @param {number} size of the lander, ft */
  constructor(materials, size) {
    this.group = new Group();
    this.materials = materials;
    this.size = size;
    /** @type {{ pad: Arrow, block: Arrow }[]} */
    this.arrows = [];
    this.scale = 1;
  }

  /**
   * @param {import("./motion.js").Motion} motion
   * @returns {number} lb that an arrow of one ft stands for: a round number, the greatest force being half of the lander's size
   */
  set(motion) {
    this.group.clear();
    this.faces = motion.drawing.vehicle.legs.map((leg) => (leg.block ? new Vector3(...leg.block.face) : null));
    this.arrows = this.faces.map(() => ({
      pad: new Arrow(0.007 * this.size, this.materials.force),
      block: new Arrow(0.007 * this.size, this.materials.blockForce),
    }));
    for (const { pad, block } of this.arrows) this.group.add(pad.group, block.group);
    this.scale = roundStep(motion.greatestForce / (0.5 * this.size));
    return this.scale;
  }

  /** @param {import("./motion.js").Pose} pose */
  place(pose) {
    for (const [index, { pad, block }] of this.arrows.entries()) {
      const leg = pose.legs[index];
      pad.point(leg.pivot, vector.copy(leg.padForce).divideScalar(this.scale));
      const face = this.faces?.[index];
      block.group.visible = face !== null;
      if (!face) continue;
      at.copy(face);
      at.z -= Math.max(leg.blockCrush, 0);
      at.applyQuaternion(pose.rotation).add(pose.center);
      block.point(at, vector.copy(leg.blockForce).divideScalar(this.scale));
    }
  }
}
