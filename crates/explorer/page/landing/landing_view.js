import { Vector3 } from "../vendor/three.js";
import { onTheme } from "../look/theme.js";
import { Body } from "./body.js";
import { Forces } from "./forces.js";
import { GroundModel } from "./ground.js";
import { Legs } from "./legs.js";
import { Marks } from "./marks.js";
import { materials } from "./materials.js";
import { Motion } from "./motion.js";
import { free } from "./shapes.js";
import { Stage } from "./stage.js";

/** @typedef {import("../engine/types.js").Landing} Landing */
/** @typedef {import("./stage.js").View} View */

/** Words of V_H and the units that the grid is drawn in. @typedef {{ words: string, fps: number, units: "US" | "SI" }} Speed */

/** A landing on a stage: lander, ground and marks, at a time. */
export class LandingView {
  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.stage = new Stage(canvas);
    this.time = 0;
    /** @type {View} */
    this.view = "corner";
    this.isFollowing = true;
    this.hasForces = true;
    /** lb that one ft of an arrow stands for, or N of one of a m. */
    this.forceScale = 0;
    this.built = "";
    onTheme(() => {
      this.built = "";
      this.stage.recolour();
      if (this.landing && this.speed) this.show(this.landing, this.speed);
    });
  }

  /** Shows a landing, at the time that is in force. @param {Landing} landing @param {Speed} speed */
  show(landing, speed) {
    if (!landing.drawing) return;
    this.landing = landing;
    this.speed = speed;
    this.motion = new Motion(landing.drawing);
    const isFirst = this.lander === undefined;
    const shape = JSON.stringify(landing.drawing.vehicle);
    if (shape !== this.built) {
      this.built = shape;
      this.#build(landing.drawing.vehicle);
    }
    const { ground, vehicle } = landing.drawing;
    this.lander?.ground.set(ground, vehicle, speed.fps, speed.words, speed.units);
    this.lander?.marks.set(this.motion);
    this.forceScale = this.lander?.forces.set(this.motion, speed.units) ?? 0;
    this.at(this.time);
    if (isFirst) this.look(this.view);
  }

  /** @param {import("../engine/types.js").VehicleShape} vehicle */
  #build(vehicle) {
    if (this.lander) {
      this.lander.all.forEach((part) => {
        free(part);
        part.removeFromParent();
      });
    }
    const reach = Math.max(...vehicle.legs.map((leg) => Math.hypot(...leg.lower_hardpoint) + leg.struts[0].length));
    const size = 2 * reach;
    const made = materials();
    const legs = new Legs(vehicle.legs, made, size);
    const body = new Body(vehicle, made, size);
    const ground = new GroundModel(made, size);
    const marks = new Marks(made, size, vehicle.legs.length);
    const forces = new Forces(made, size, vehicle);
    const all = [body, ground, marks, forces, legs].map(({ group }) => group);
    this.lander = { legs, body, ground, marks, forces, all };
    this.stage.frame.add(...all);
    this.stage.resize(size);
  }

  /** Shows an instant. @param {number} time s after first contact */
  at(time) {
    this.time = time;
    if (!this.motion || !this.lander) return;
    const pose = this.motion.at(time);
    this.lander.body.place(pose);
    this.lander.ground.place(pose.center);
    this.lander.legs.place(pose);
    this.lander.marks.place(pose, this.motion.index(time) / Math.max(this.motion.times.length - 1, 1));
    this.lander.forces.group.visible = this.hasForces;
    this.lander.forces.place(pose);
    this.stage.follow(pose.center, this.isFollowing);
    this.stage.draw();
  }

  /** Looks at the lander from a named view. @param {View} view */
  look(view) {
    this.view = view;
    const at = new Vector3();
    if (this.motion) at.copy(this.motion.at(this.time).center);
    this.stage.look(view, at);
  }
}
