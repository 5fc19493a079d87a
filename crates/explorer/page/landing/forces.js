import { Vector3 } from "../vendor/three.js";
import { roundStep } from "../look/words.js";
import { Arrows } from "./shapes.js";

/** @typedef {import("./materials.js").Materials} Materials */
/** @typedef {import("../engine/types.js").VehicleShape} VehicleShape */

/** How many N/m one lb/ft is. */
const NEWTON_A_METRE = 4.4482216152605 / 0.3048;
const vector = new Vector3();
const at = new Vector3();

/** Forces of the ground on pads and blocks. */
export class Forces {
  /** @param {Materials} materials @param {number} size of the lander, ft @param {VehicleShape} vehicle */
  constructor(materials, size, vehicle) {
    this.size = size;
    this.faces = vehicle.legs.map((leg) => (leg.block ? new Vector3(...leg.block.face) : null));
    // An arrow for each pad, then one for each block.
    const colours = [materials.force, materials.blockForce].flatMap((colour) => this.faces.map(() => colour));
    this.arrows = new Arrows(0.007 * size, materials.marks, colours);
    this.group = this.arrows.group;
    this.scale = 1;
  }

  /**
   * @param {import("./motion.js").Motion} motion
   * @param {"US" | "SI"} units
   * @returns {number} lb that an arrow of one ft stands for, or N of one of a m: a round number, the greatest force being half of the lander's size
   */
  set(motion, units) {
    const inOne = units === "SI" ? NEWTON_A_METRE : 1;
    const scale = roundStep((inOne * motion.greatestForce) / (0.5 * this.size));
    this.scale = scale / inOne;
    return scale;
  }

  /** @param {import("./motion.js").Pose} pose */
  place(pose) {
    for (const [index, face] of this.faces.entries()) {
      const leg = pose.legs[index];
      this.arrows.point(index, leg.pivot, vector.copy(leg.padForce).divideScalar(this.scale));
      if (face) {
        at.copy(face);
        at.z -= Math.max(leg.blockCrush, 0);
        at.applyQuaternion(pose.rotation).add(pose.center);
      }
      vector.copy(leg.blockForce).divideScalar(this.scale);
      this.arrows.point(this.faces.length + index, at, face ? vector : vector.set(0, 0, 0));
    }
  }
}
