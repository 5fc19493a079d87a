import {
  BufferAttribute, BufferGeometry, CanvasTexture, ConeGeometry, CylinderGeometry, Group, Mesh, Quaternion, Sprite, SpriteMaterial,
  SRGBColorSpace, Vector3,
} from "../vendor/three.js";

/** @typedef {import("../vendor/three.js").Material} Material */

const UP = new Vector3(0, 1, 0);
const direction = new Vector3();
const CYLINDER = new CylinderGeometry(1, 1, 1, 14, 1);
const CONE = new ConeGeometry(1, 1, 18, 1);

/** A rod of a radius, to be laid between two points. @param {number} radius @param {Material} material */
export function rod(radius, material) {
  const mesh = new Mesh(CYLINDER, material);
  mesh.scale.set(radius, 1, radius);
  mesh.castShadow = true;
  return mesh;
}

/** Lays a rod between two points. @param {Mesh} mesh @param {Vector3} from @param {Vector3} to */
export function lay(mesh, from, to) {
  direction.subVectors(to, from);
  const length = direction.length();
  mesh.visible = length > 1e-6;
  if (!mesh.visible) return;
  mesh.position.addVectors(from, to).multiplyScalar(0.5);
  mesh.quaternion.setFromUnitVectors(UP, direction.divideScalar(length));
  mesh.scale.y = length;
}

/** An arrow with its tail at its origin. */
export class Arrow {
  /** @param {number} radius of its shaft @param {Material} material */
  constructor(radius, material) {
    this.group = new Group();
    this.shaft = new Mesh(CYLINDER, material);
    this.head = new Mesh(CONE, material);
    this.radius = radius;
    this.group.add(this.shaft, this.head);
  }

  /** @param {Vector3} tail @param {Vector3} vector from tail to tip */
  point(tail, vector) {
    const length = vector.length();
    this.group.visible = length > 0.02;
    if (!this.group.visible) return;
    this.group.position.copy(tail);
    this.group.quaternion.copy(turned.setFromUnitVectors(UP, direction.copy(vector).divideScalar(length)));
    const head = Math.min(6 * this.radius, 0.6 * length);
    this.shaft.scale.set(this.radius, length - head, this.radius);
    this.shaft.position.y = 0.5 * (length - head);
    this.head.scale.set(2.6 * this.radius * Math.min(1, head / (6 * this.radius)), head, 2.6 * this.radius * Math.min(1, head / (6 * this.radius)));
    this.head.position.y = length - 0.5 * head;
  }
}
const turned = new Quaternion();

/** A word that always faces the reader. */
export class Label {
  /** @param {number} height of its letters, ft */
  constructor(height) {
    this.canvas = document.createElement("canvas");
    this.texture = new CanvasTexture(this.canvas);
    this.texture.colorSpace = SRGBColorSpace;
    const material = new SpriteMaterial({ map: this.texture, depthTest: false, transparent: true, fog: false });
    this.sprite = new Sprite(material);
    this.sprite.renderOrder = 10;
    this.height = height;
    this.written = "";
  }

  /** @param {string} text @param {string} colour @param {string} halo */
  write(text, colour, halo) {
    const now = [text, colour, halo].join();
    if (now === this.written) return;
    this.written = now;
    Object.assign(this.sprite.userData, { text, colour });
    const size = 44;
    const context = /** @type {CanvasRenderingContext2D} */ (this.canvas.getContext("2d"));
    const font = `600 ${size}px system-ui, sans-serif`;
    // What follows an underscore is a subscript of one letter.
    const runs = text.split(/_(.)/).map((run, index) => ({ run, isLow: index % 2 === 1 }));
    const small = `600 ${0.7 * size}px system-ui, sans-serif`;
    const widthOf = (/** @type {{ run: string, isLow: boolean }} */ { run, isLow }) => {
      context.font = isLow ? small : font;
      return context.measureText(run).width;
    };
    const width = Math.ceil(runs.reduce((sum, run) => sum + widthOf(run), 0)) + 16;
    this.canvas.width = width;
    this.canvas.height = size * 1.4;
    Object.assign(context, { textBaseline: "middle", lineJoin: "round", lineWidth: 8, strokeStyle: halo, fillStyle: colour });
    for (const draw of [context.strokeText, context.fillText]) {
      let left = 8;
      for (const run of runs) {
        const wide = widthOf(run);
        draw.call(context, run.run, left, size * (run.isLow ? 0.92 : 0.7));
        left += wide;
      }
    }
    this.texture.dispose();
    this.texture.needsUpdate = true;
    this.sprite.scale.set((this.height * 1.4 * width) / this.canvas.height, this.height * 1.4, 1);
  }
}

/**
 * A triangle whose corners move.
 * @param {Material} material
 */
export function triangle(material) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(9), 3));
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  return mesh;
}

/** @param {Mesh} mesh @param {Vector3} a @param {Vector3} b @param {Vector3} c */
export function span(mesh, a, b, c) {
  const position = mesh.geometry.getAttribute("position");
  for (const [index, corner] of [a, b, c].entries()) position.setXYZ(index, corner.x, corner.y, corner.z);
  position.needsUpdate = true;
}

/** Frees what a tree of meshes has on the graphics card. @param {import("../vendor/three.js").Object3D} tree */
export function free(tree) {
  tree.traverse((part) => {
    if (part instanceof Mesh && part.geometry !== CYLINDER && part.geometry !== CONE) part.geometry.dispose();
  });
}
