import { Color, Group, Matrix4, Mesh, MeshBasicMaterial, PlaneGeometry, RingGeometry, ShadowMaterial, Vector3 } from "../vendor/three.js";
import { colours } from "../look/theme.js";
import { patchOf } from "./patch.js";
import { Arrows, Label } from "./shapes.js";

/** @typedef {import("./materials.js").Materials} Materials */

/** Half the side of the ground that is drawn, ft. */
const HALF = 160;
/** Length of the arrow of V_H in sizes of the lander, for each ft/s. */
const LENGTH_A_SPEED = 0.024;
const FEET_A_METRE = 1 / 0.3048;
/** Most holes that the surface has: under the pads and blocks of eight legs. */
const HOLES = 16;

/**
 * A material with a grid and holes: every fifth line is bold. Lines are computed at every pixel: a texture costs a processor without a
 * graphics card four times as much.
 * @param {string} ground @param {string} line
 */
function gridMaterial(ground, line) {
  const material = new MeshBasicMaterial({ color: ground });
  /** Distance of the fine lines, ft. */
  const step = { value: 1 };
  /** Middles of the holes along the plane, and their radii; ft. */
  const holes = { value: Array.from({ length: HOLES }, () => new Vector3()) };
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, { step, holes, lineColour: { value: new Color(line) } });
    shader.vertexShader = shader.vertexShader
      .replace("#include <common>", "#include <common>\nvarying vec2 at;")
      .replace("#include <begin_vertex>", "#include <begin_vertex>\nat = position.xy;");
    shader.fragmentShader = shader.fragmentShader
      .replace("#include <common>", `#include <common>\nvarying vec2 at;\nuniform float step;\nuniform vec3 holes[${HOLES}];\nuniform vec3 lineColour;\n${GRID}`)
      .replace("#include <map_fragment>", `for (int i = 0; i < ${HOLES}; i++) if (distance(at, holes[i].xy) < holes[i].z) discard;
diffuseColor.rgb = mix(diffuseColor.rgb, lineColour, max(0.4 * gridLines(at / step, 0.03), 0.75 * gridLines(at / (5.0 * step), 0.0125)));`);
  };
  return { material, step, holes };
}

/** How much of a pixel lines at whole numbers cover, `width` wide: never thinner than a pixel, but paler. */
const GRID = `
float gridLines(vec2 at, float width) {
  vec2 rate = fwidth(at);
  vec2 drawn = clamp(vec2(width), rate, vec2(0.5));
  vec2 away = 1.0 - abs(fract(at) * 2.0 - 1.0);
  vec2 lines = smoothstep(drawn + 1.5 * rate, drawn - 1.5 * rate, away) * min(width / drawn, 1.0);
  lines = mix(lines, vec2(width), clamp(2.0 * rate - 1.0, 0.0, 1.0));
  return mix(lines.x, 1.0, lines.y);
}`;

/** The surface with its grid, the ground under pads that is not the surface, and arrows downhill and along V_H. */
export class GroundModel {
  /** @param {Materials} materials @param {number} size of the lander, ft */
  constructor(materials, size) {
    this.group = new Group();
    this.materials = materials;
    this.size = size;
    const { ground, gridLine } = colours().scene;
    this.grid = gridMaterial(ground, gridLine);
    this.surface = new Mesh(new PlaneGeometry(2 * HALF, 2 * HALF), this.grid.material);
    this.surface.matrixAutoUpdate = false;
    // A plane has one shade all over. Only the ground about the lander asks what is in its shadow.
    this.shadow = new Mesh(new PlaneGeometry(2.4 * size, 2.4 * size), new ShadowMaterial({ opacity: 0.42 }));
    this.shadow.matrixAutoUpdate = false;
    this.shadow.receiveShadow = true;
    // Downhill, then V_H.
    this.arrows = new Arrows(0.0085 * size, materials.marks, [materials.downhill.color, materials.velocity]);
    this.words = { downhill: new Label(0.036 * size), velocity: new Label(0.036 * size) };
    this.patches = new Group();
    this.group.add(
      this.surface, this.shadow, this.patches, this.arrows.group, this.words.downhill.sprite, this.words.velocity.sprite,
    );
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
    this.plane = { normal, at, across, downhill };
    // A bold line runs through the point below the CG.
    this.grid.step.value = units === "SI" ? 0.2 * FEET_A_METRE : 1;
    const { size } = this;
    const raised = at.clone().addScaledVector(normal, 0.02 * size);
    const side = raised.clone().addScaledVector(across, 0.62 * size).addScaledVector(downhill, -0.2 * size);
    this.arrows.point(0, side, downhill.clone().multiplyScalar(0.3 * size));
    const { paper, stable, paleText } = colours();
    this.words.downhill.write("downhill", paleText, paper);
    this.words.downhill.sprite.position.copy(side).addScaledVector(downhill, 0.35 * size);
    const along = new Vector3(...ground.velocity_direction);
    along.addScaledVector(normal, -along.dot(normal)).normalize();
    const tail = raised.clone().addScaledVector(across, -0.5 * size).addScaledVector(downhill, -0.15 * size);
    this.arrows.point(1, tail, along.clone().multiplyScalar(LENGTH_A_SPEED * speed * size));
    this.words.velocity.write(speedWords, stable, paper);
    this.words.velocity.sprite.position.copy(tail).addScaledVector(normal, 0.05 * size);
    this.words.velocity.sprite.visible = speed > 0;
    this.#drawPatches(ground, vehicle);
  }

  /** Keeps the shadow under the lander. @param {Vector3} center of gravity */
  place(center) {
    if (!this.plane) return;
    const { normal, at } = this.plane;
    const height = center.clone().sub(at).dot(normal);
    this.shadow.matrix.copy(this.surface.matrix).setPosition(center.clone().addScaledVector(normal, 0.015 - height));
    this.shadow.matrixWorldNeedsUpdate = true;
  }

  /** @param {import("../engine/types.js").Ground} ground @param {import("../engine/types.js").VehicleShape} vehicle */
  #drawPatches(ground, vehicle) {
    const { plane } = this;
    if (!plane) return;
    const holes = this.grid.holes.value;
    for (const hole of holes) hole.z = 0;
    let count = 0;
    for (const patch of [...this.patches.children]) {
      /** @type {Mesh} */ (patch).geometry.dispose();
      patch.removeFromParent();
    }
    for (const patch of ground.patches) {
      if (patch.of === "block" && patch.is_even) continue;
      const leg = vehicle.legs[patch.leg - 1];
      const radius = patch.of === "pad" ? 0.85 * leg.footpad.diameter : 0.8 * (leg.block?.diameter ?? 0);
      const [point, normal] = [new Vector3(...patch.point), new Vector3(...patch.normal)];
      if (patch.is_even) {
        const ring = new Mesh(new RingGeometry(0.94 * radius, radius, 40), this.materials.downhill);
        ring.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), normal);
        ring.position.copy(point).addScaledVector(normal, 0.02);
        this.patches.add(ring);
        continue;
      }
      const { geometry, foot, hole } = patchOf(point, normal, 1.6 * radius, plane);
      const mesh = new Mesh(geometry, this.materials.earth);
      mesh.receiveShadow = true;
      this.patches.add(mesh);
      foot.sub(plane.at);
      if (hole === 0 || count === HOLES) continue;
      holes[count].set(foot.dot(plane.across), foot.dot(plane.downhill), hole);
      count += 1;
    }
  }
}
