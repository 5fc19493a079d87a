import {
  CanvasTexture, CircleGeometry, Group, Matrix4, Mesh, MeshBasicMaterial, PlaneGeometry, RepeatWrapping, RingGeometry,
  ShadowMaterial, SRGBColorSpace, Vector3,
} from "../vendor/three.js";
import { colours } from "../look/theme.js";
import { Arrow, Label } from "./shapes.js";
import { sharpness } from "./sharpness.js";

/** @typedef {import("./materials.js").Materials} Materials */

/** Half the side of the ground that is drawn, ft. */
const HALF = 160;
/** Length of the arrow of V_H in sizes of the lander, for each ft/s. */
const LENGTH_A_SPEED = 0.024;
const FEET_A_METRE = 1 / 0.3048;

/** Every fifth line of the grid is bold. */
const LINES = 5;
/** Side of a tile of the grid, pixels. */
const TILE = 640;

/** A tile of the grid. @param {string} ground @param {string} line */
function gridTexture(ground, line) {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = TILE;
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  context.fillStyle = ground;
  context.fillRect(0, 0, TILE, TILE);
  context.fillStyle = line;
  for (let index = 0; index <= LINES; index += 1) {
    const isBold = index % LINES === 0;
    context.globalAlpha = isBold ? 0.75 : 0.4;
    const [at, width] = [(index * TILE) / LINES, isBold ? 8 : 4];
    context.fillRect(at - 0.5 * width, 0, width, TILE);
    context.fillRect(0, at - 0.5 * width, TILE, width);
  }
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.anisotropy = sharpness().smooths ? 8 : 1;
  return texture;
}

/** The surface with its grid, the ground under pads that is not the surface, and arrows downhill and along V_H. */
export class GroundModel {
  /** @param {Materials} materials @param {number} size of the lander, ft */
  constructor(materials, size) {
    this.group = new Group();
    this.materials = materials;
    this.size = size;
    /** Distance of the fine lines of the grid, ft. */
    this.gridStep = 1;
    const { ground, gridLine } = colours().scene;
    this.grid = gridTexture(ground, gridLine);
    this.surface = new Mesh(new PlaneGeometry(2 * HALF, 2 * HALF), new MeshBasicMaterial({ map: this.grid }));
    this.surface.matrixAutoUpdate = false;
    // A plane has one shade all over. Only the ground about the lander asks what is in its shadow.
    this.shadow = new Mesh(new PlaneGeometry(2.4 * size, 2.4 * size), new ShadowMaterial({ opacity: 0.42 }));
    this.shadow.matrixAutoUpdate = false;
    this.shadow.receiveShadow = true;
    this.downhill = new Arrow(0.008 * size, materials.downhill);
    this.velocity = new Arrow(0.009 * size, materials.velocity);
    this.words = { downhill: new Label(0.036 * size), velocity: new Label(0.036 * size) };
    this.patches = new Group();
    this.group.add(
      this.surface, this.shadow, this.patches, this.downhill.group, this.velocity.group, this.words.downhill.sprite, this.words.velocity.sprite,
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
    this.plane = { normal, at };
    this.gridStep = units === "SI" ? 0.2 * FEET_A_METRE : 1;
    const tiles = (2 * HALF) / (LINES * this.gridStep);
    this.grid.repeat.set(tiles, tiles);
    // A bold line runs through the point below the CG.
    this.grid.offset.set(-0.5 * tiles, -0.5 * tiles);
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
