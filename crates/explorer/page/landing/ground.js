import {
  CircleGeometry, Color, Group, Matrix4, Mesh, MeshLambertMaterial, PlaneGeometry, RingGeometry, Vector3,
} from "../vendor/three.js";
import { colours } from "../look/theme.js";
import { Arrow, Label } from "./shapes.js";

/** @typedef {import("./materials.js").Materials} Materials */

/** Half the side of the ground that is drawn, ft. */
const HALF = 160;
/** Length of the arrow of V_H in sizes of the lander, for each ft/s. */
const LENGTH_A_SPEED = 0.024;
const FEET_A_METRE = 1 / 0.3048;

/** The surface with its grid, the ground under pads that is not the surface, and arrows downhill and along V_H. */
export class GroundModel {
  /** @param {Materials} materials @param {number} size of the lander, ft */
  constructor(materials, size) {
    this.group = new Group();
    this.materials = materials;
    this.size = size;
    this.grid = { uGrid: { value: 1 }, uBold: { value: 5 }, uLine: { value: new Color() }, uFar: { value: 60 } };
    this.surface = new Mesh(new PlaneGeometry(2 * HALF, 2 * HALF), this.#surfaceMaterial());
    this.surface.matrixAutoUpdate = false;
    this.surface.receiveShadow = true;
    this.downhill = new Arrow(0.008 * size, materials.downhill);
    this.velocity = new Arrow(0.009 * size, materials.velocity);
    this.words = { downhill: new Label(0.036 * size), velocity: new Label(0.036 * size) };
    this.patches = new Group();
    this.group.add(
      this.surface, this.patches, this.downhill.group, this.velocity.group, this.words.downhill.sprite, this.words.velocity.sprite,
    );
  }

  /** Lambert's law with lines every foot, or every quarter of a metre, that fade with the distance. */
  #surfaceMaterial() {
    const material = new MeshLambertMaterial({ color: colours().scene.ground });
    this.grid.uLine.value.set(colours().scene.gridLine);
    material.onBeforeCompile = (shader) => {
      Object.assign(shader.uniforms, this.grid);
      shader.vertexShader = shader.vertexShader
        .replace("#include <common>", "#include <common>\nvarying vec2 vPlace;")
        .replace("#include <begin_vertex>", "#include <begin_vertex>\nvPlace = position.xy;");
      shader.fragmentShader = shader.fragmentShader
        .replace(
          "#include <common>",
          `#include <common>
          varying vec2 vPlace;
          uniform float uGrid, uBold, uFar;
          uniform vec3 uLine;
          float onLine(vec2 place, float step, float breadth) {
            vec2 scaled = place / step;
            vec2 wide = max(fwidth(scaled), vec2(1e-6));
            vec2 near = abs(fract(scaled - 0.5) - 0.5) / wide;
            float line = 1.0 - clamp(min(near.x, near.y) - breadth + 1.0, 0.0, 1.0);
            return line * clamp(1.0 - 2.2 * max(wide.x, wide.y), 0.0, 1.0);
          }`,
        )
        .replace(
          "#include <color_fragment>",
          `#include <color_fragment>
          float fade = 1.0 - smoothstep(0.25 * uFar, uFar, length(vPlace));
          float line = max(0.33 * onLine(vPlace, uGrid, 1.0), 0.7 * onLine(vPlace, uBold, 1.3));
          diffuseColor.rgb = mix(diffuseColor.rgb, uLine, line * fade);`,
        );
    };
    return material;
  }

  /**
   * @param {import("../engine/types.js").Ground} ground
   * @param {import("../engine/types.js").VehicleShape} vehicle
   * @param {number} speed V_H, ft/s
   * @param {string} speedWords V_H in the units of the page
   * @param {"US" | "SI"} units
   */
  set(ground, vehicle, speed, speedWords, units) {
    const normal = new Vector3(...ground.normal);
    const downhill = new Vector3(...ground.downhill);
    const across = new Vector3().crossVectors(downhill, normal);
    const at = new Vector3(...ground.surface_point);
    this.surface.matrix.copy(new Matrix4().makeBasis(across, downhill, normal).setPosition(at));
    this.surface.matrixWorldNeedsUpdate = true;
    const [fine, bold] = units === "SI" ? [0.25 * FEET_A_METRE, FEET_A_METRE] : [1, 5];
    this.grid.uGrid.value = fine;
    this.grid.uBold.value = bold;
    const { size } = this;
    const raised = at.clone().addScaledVector(normal, 0.02 * size);
    const side = raised.clone().addScaledVector(across, 0.62 * size).addScaledVector(downhill, -0.2 * size);
    this.downhill.point(side, downhill.clone().multiplyScalar(0.3 * size));
    const { paper, stable, paleText } = colours();
    this.words.downhill.write("downhill", paleText, paper);
    this.words.downhill.sprite.position.copy(side).addScaledVector(downhill, 0.35 * size);
    const along = new Vector3(...ground.velocity_direction);
    along.addScaledVector(normal, -along.dot(normal)).normalize();
    const tail = raised.clone().addScaledVector(across, -0.5 * size).addScaledVector(downhill, -0.15 * size);
    this.velocity.point(tail, along.clone().multiplyScalar(LENGTH_A_SPEED * speed * size));
    this.words.velocity.write(speedWords, stable, paper);
    this.words.velocity.sprite.position.copy(tail).addScaledVector(normal, 0.05 * size);
    this.words.velocity.sprite.visible = speed > 0;
    this.#drawPatches(ground, vehicle);
  }

  /** @param {import("../engine/types.js").Ground} ground @param {import("../engine/types.js").VehicleShape} vehicle */
  #drawPatches(ground, vehicle) {
    for (const patch of [...this.patches.children]) {
      /** @type {Mesh} */ (patch).geometry.dispose();
      patch.removeFromParent();
    }
    for (const patch of ground.patches) {
      if (patch.of === "block" && patch.is_even) continue;
      const leg = vehicle.legs[patch.leg - 1];
      const radius = patch.of === "pad" ? 0.85 * leg.footpad.diameter : 0.8 * (leg.block?.diameter ?? 0);
      const mesh = patch.is_even
        ? new Mesh(new RingGeometry(0.94 * radius, radius, 40), this.materials.downhill)
        : new Mesh(new CircleGeometry(1.6 * radius, 40), this.materials.honeycomb);
      const normal = new Vector3(...patch.normal);
      mesh.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), normal);
      mesh.position.set(...patch.point).addScaledVector(normal, 0.02);
      mesh.receiveShadow = !patch.is_even;
      this.patches.add(mesh);
    }
  }
}
