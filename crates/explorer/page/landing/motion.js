import { Matrix4, Quaternion, Vector3 } from "../vendor/three.js";

/** @typedef {import("../engine/types.js").Drawing} Drawing */

/**
 * Where everything is at an instant, in ground axes, in ft and lb.
 * @typedef {{ center: Vector3, rotation: Quaternion, legs: LegPose[], criticalEdge: [number, number] | null,
 *   stabilityAngle: number }} Pose
 * @typedef {{ pivot: Vector3, padAxis: Vector3, padCrush: [number, number], blockCrush: number, strokes: number[],
 *   padForce: Vector3, blockForce: Vector3 }} LegPose
 */

/** A landing between its instants. */
export class Motion {
  /** @param {Drawing} drawing */
  constructor(drawing) {
    this.drawing = drawing;
    const { time_s, rotation, legs } = drawing.instants;
    this.times = time_s;
    this.end = time_s[time_s.length - 1];
    this.rotations = rotation.map(quaternion);
    for (let i = 1; i < this.rotations.length; i += 1) {
      const [before, after] = [this.rotations[i - 1], this.rotations[i]];
      if (before.dot(after) < 0) after.set(-after.x, -after.y, -after.z, -after.w);
    }
    /** @type {Pose} */
    this.pose = {
      center: new Vector3(),
      rotation: new Quaternion(),
      legs: legs.map(() => ({
        pivot: new Vector3(),
        padAxis: new Vector3(),
        padCrush: [0, 0],
        blockCrush: 0,
        strokes: [],
        padForce: new Vector3(),
        blockForce: new Vector3(),
      })),
      criticalEdge: null,
      stabilityAngle: 0,
    };
  }

  /** The greatest force of the ground on a footpad or a block, lb. */
  get greatestForce() {
    const forces = this.drawing.instants.legs.flatMap((leg) => [...leg.pad_force, ...leg.block_force]);
    return forces.reduce((most, force) => Math.max(most, Math.hypot(...force)), 0);
  }

  /** Number of the last instant that is not after a time. @param {number} time */
  index(time) {
    let [low, high] = [0, this.times.length - 1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.times[middle] <= time) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /** The pose at a time; it holds until the next call. @param {number} time s */
  at(time) {
    const { instants } = this.drawing;
    const i = this.index(time);
    const j = Math.min(i + 1, this.times.length - 1);
    const span = this.times[j] - this.times[i];
    const part = span > 0 ? Math.min(Math.max((time - this.times[i]) / span, 0), 1) : 0;
    const { pose } = this;
    const between = (/** @type {Vector3} */ into, /** @type {number[][]} */ list) =>
      into.set(...three(0, 1, 2, (axis) => list[i][axis] + part * (list[j][axis] - list[i][axis])));
    const mix = (/** @type {(number | number[])[]} */ list, axis = 0) => {
      const [before, after] = [list[i], list[j]].map((value) => (typeof value === "number" ? value : value[axis]));
      return before + part * (after - before);
    };
    between(pose.center, instants.center_of_gravity);
    pose.rotation.copy(this.rotations[i]).slerp(this.rotations[j], part);
    for (const [number, leg] of instants.legs.entries()) {
      const into = pose.legs[number];
      between(into.pivot, leg.pivot);
      between(into.padAxis, leg.pad_axis).normalize();
      between(into.padForce, leg.pad_force);
      between(into.blockForce, leg.block_force);
      // What is pressed in now may be elastic and more than what stays.
      for (const half of /** @type {const} */ ([0, 1])) {
        into.padCrush[half] = Math.max(mix(leg.pad_crush, half), mix(leg.pad_interference, half));
      }
      into.blockCrush = Math.max(mix(leg.block_crush), mix(leg.block_interference));
      into.strokes = leg.strokes[i].map((_, strut) => mix(leg.strokes, strut));
    }
    const near = part < 0.5 ? i : j;
    pose.criticalEdge = instants.critical_edge[near];
    pose.stabilityAngle = mix(instants.stability_angle_deg);
    return pose;
  }
}

/**
 * @template T
 * @param {number} a @param {number} b @param {number} c
 * @param {(axis: number) => T} of
 * @returns {[T, T, T]}
 */
function three(a, b, c, of) {
  return [of(a), of(b), of(c)];
}

/** @param {number[]} rows a rotation matrix, row by row */
function quaternion(rows) {
  const [a, b, c, d, e, f, g, h, i] = rows;
  return new Quaternion().setFromRotationMatrix(new Matrix4().set(a, b, c, 0, d, e, f, 0, g, h, i, 0, 0, 0, 0, 1));
}
