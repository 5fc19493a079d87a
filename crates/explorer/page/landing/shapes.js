import {
  BufferAttribute, BufferGeometry, CanvasTexture, ConeGeometry, CylinderGeometry, Group, InstancedMesh, Matrix4, Mesh, MeshBasicMaterial,
  Quaternion, Sprite, SpriteMaterial, SRGBColorSpace, Vector3,
} from "../vendor/three.js";

/** @typedef {import("../vendor/three.js").Material} Material */
/** @typedef {import("../vendor/three.js").Color} Color */

const UP = new Vector3(0, 1, 0);
const [direction, middle, scale, tip] = [0, 1, 2, 3].map(() => new Vector3());
const turned = new Quaternion();
const placed = new Matrix4();
const CYLINDER = new CylinderGeometry(1, 1, 1, 14, 1);
const CONE = new ConeGeometry(1, 1, 18, 1);

/** Copies of one shape, drawn in one call, each with its own place and colour. */
export class Copies extends InstancedMesh {
  /** @param {BufferGeometry} geometry @param {Material} material @param {number} count */
  constructor(geometry, material, count) {
    super(geometry, material, count);
    this.frustumCulled = false;
    this.castShadow = !(material instanceof MeshBasicMaterial);
  }

  /** @param {number} index @param {Matrix4} matrix */
  setMatrixAt(index, matrix) {
    this.instanceMatrix.needsUpdate = true;
    return super.setMatrixAt(index, matrix);
  }

  /** @param {number} index @param {Color} colour */
  setColorAt(index, colour) {
    super.setColorAt(index, colour);
    if (this.instanceColor) this.instanceColor.needsUpdate = true;
    return this;
  }
}

/** Rods, each laid between two points. */
export class Rods extends Copies {
  /** @param {Material} material @param {number} count */
  constructor(material, count) {
    super(CYLINDER, material, count);
  }

  /** One of no length is not seen. @param {number} index @param {number} radius @param {Vector3} from @param {Vector3} to */
  lay(index, radius, from, to) {
    direction.subVectors(to, from);
    const length = direction.length();
    turned.setFromUnitVectors(UP, length > 1e-6 ? direction.divideScalar(length) : UP);
    const width = length > 1e-6 ? radius : 0;
    this.setMatrixAt(index, placed.compose(middle.addVectors(from, to).multiplyScalar(0.5), turned, scale.set(width, length, width)));
  }
}

/** Arrows of one thickness. */
export class Arrows {
  /** @param {number} radius of a shaft @param {Material} material @param {Color[]} colours of the arrows */
  constructor(radius, material, colours) {
    this.radius = radius;
    this.shafts = new Rods(material, colours.length);
    this.heads = new Copies(CONE, material, colours.length);
    for (const part of [this.shafts, this.heads]) colours.forEach((colour, index) => part.setColorAt(index, colour));
    this.group = new Group();
    this.group.add(this.shafts, this.heads);
  }

  /** Without a length to speak of there is none. @param {number} index @param {Vector3} tail @param {Vector3} vector from tail to tip */
  point(index, tail, vector) {
    const length = vector.length() > 0.02 ? vector.length() : 0;
    const head = Math.min(6 * this.radius, 0.6 * length);
    const wide = 2.6 * this.radius * Math.min(1, head / (6 * this.radius));
    tip.copy(vector).setLength(length - head).add(tail);
    this.shafts.lay(index, this.radius, tail, tip);
    turned.setFromUnitVectors(UP, length ? direction.copy(vector).normalize() : UP);
    this.heads.setMatrixAt(index, placed.compose(tip.addScaledVector(direction, 0.5 * head), turned, scale.set(wide, head, wide)));
  }
}

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
    if (part instanceof InstancedMesh) part.dispose();
    if (part instanceof Mesh && part.geometry !== CYLINDER && part.geometry !== CONE) part.geometry.dispose();
  });
}
