import { Color, Group, Vector3 } from "../vendor/three.js";
import { Footpad } from "./footpad.js";
import { Rods } from "./shapes.js";

/** @typedef {import("./materials.js").Materials} Materials */
/** @typedef {import("./motion.js").Pose} Pose */
/** @typedef {import("../engine/types.js").StrutShape} StrutShape */

/** Part of the extended strut that its sleeve takes. */
const SLEEVE = 0.6;
/** Rods of a fork; and sleeve and rod of a strut. */
const [FORK, STRUT] = [2, 2];
const [hinge, foot, outboard] = [0, 1, 2].map(() => new Vector3());
const [start, joint, end, primary] = [0, 1, 2, 3].map(() => new Vector3());
const colour = new Color();

/** The legs: of each the lower link as a fork, if it has one, its struts, each with its rod in its sleeve, and the footpad. */
export class Legs {
  /** @param {import("../engine/types.js").LegShape[]} shapes @param {Materials} materials @param {number} size of the lander, ft */
  constructor(shapes, materials, size) {
    this.materials = materials;
    this.size = size;
    let count = 0;
    this.legs = shapes.map((shape) => {
      const hasLink = shape.link_length !== null;
      const fork = count;
      const first = count + (hasLink ? FORK : 0);
      count = first + STRUT * shape.struts.length;
      const [x, y] = shape.outboard;
      const sleeveOf = (/** @type {StrutShape} */ { length }, /** @type {number} */ index) =>
        // The collar is on the sleeve of the first strut.
        Math.max(SLEEVE * length, ...shape.struts.map(({ collar }) => (index === 0 ? collar ?? 0 : 0)));
      return {
        fork,
        first,
        struts: shape.struts.map((strut, index) => ({ ...strut, from: new Vector3(...strut.from), sleeve: sleeveOf(strut, index) })),
        pad: new Footpad(shape.footpad, materials),
        outboard: new Vector3(x, y, 0),
        sideways: new Vector3(y, -x, 0).multiplyScalar(0.06 * size),
        linkFrom: hasLink ? new Vector3(...shape.lower_hardpoint) : null,
      };
    });
    this.rods = new Rods(materials.copies, count);
    for (const { fork, first, struts } of this.legs) {
      for (let side = fork; side < first; side += 1) this.rods.setColorAt(side, materials.metal.color);
      for (const index of struts.keys()) this.rods.setColorAt(first + STRUT * index + 1, materials.rod);
    }
    this.group = new Group();
    this.group.add(this.rods, ...this.legs.map(({ pad }) => pad.group));
  }

  /** @param {Pose} pose */
  place(pose) {
    const toGround = (/** @type {Vector3} */ into, /** @type {Vector3} */ point) =>
      into.copy(point).applyQuaternion(pose.rotation).add(pose.center);
    for (const [index, leg] of this.legs.entries()) {
      const { pivot, padAxis, padCrush, strokes } = pose.legs[index];
      foot.copy(pivot);
      for (let side = 0; leg.linkFrom && side < FORK; side += 1) {
        hinge.copy(leg.linkFrom).addScaledVector(leg.sideways, side === 0 ? 1 : -1);
        this.rods.lay(leg.fork + side, 0.0085 * this.size, toGround(hinge, hinge), foot);
      }
      toGround(primary, leg.struts[0].from);
      for (const [number, strut] of leg.struts.entries()) {
        const rod = leg.first + STRUT * number;
        toGround(start, strut.from);
        end.copy(foot);
        if (strut.collar !== null) end.sub(primary).setLength(strut.collar).add(primary);
        joint.copy(start).lerp(end, Math.min(strut.sleeve / start.distanceTo(end), 0.97));
        this.rods.lay(rod, 0.017 * this.size, start, joint);
        this.rods.lay(rod + 1, 0.01 * this.size, joint, end);
        this.rods.setColorAt(rod, colour.copy(this.materials.sleeve).lerp(this.materials.stroked, shareOf(strokes[number], strut)));
      }
      leg.pad.place(foot, padAxis, outboard.copy(leg.outboard).applyQuaternion(pose.rotation), padCrush);
    }
  }
}

/** Part that a stroke takes of the greatest one its way. @param {number} stroke @param {{ length: number, minimum_length: number, maximum_length: number }} strut */
function shareOf(stroke, strut) {
  const greatest = stroke > 0 ? strut.length - strut.minimum_length : strut.maximum_length - strut.length;
  return greatest > 0 ? Math.min(Math.abs(stroke) / greatest, 1) : 0;
}
