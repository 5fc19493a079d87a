import {
  BasicShadowMap, Color, DirectionalLight, Fog, Group, HemisphereLight, PCFShadowMap, PerspectiveCamera, Scene, SRGBColorSpace, Vector3, WebGLRenderer,
  OrbitControls,
} from "../vendor/three.js";
import { colours } from "../look/theme.js";
import { sharpness, STILL } from "./sharpness.js";

/** Where the camera stands, in ground axes relative to what it looks at, in sizes of the lander. */
const VIEWS = {
  corner: [1.35, 1.05, -0.72],
  uphill: [0, 1.85, -0.75],
  downhill: [0, -2, -0.3],
  side: [2.1, 0, -0.16],
  top: [0, 0.001, -2.5],
};
/** Mean interval of pictures that is too long, ms, and the coarsest they become for it. */
const SLOW = 36;
const COARSEST = 0.5;

/** @typedef {keyof typeof VIEWS} View */

/** A picture of three dimensions on a canvas: lights, camera, and a frame whose axes are those of the ground. */
export class Stage {
  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.canvas = canvas;
    this.sharpness = sharpness();
    this.renderer = new WebGLRenderer({ canvas, antialias: this.sharpness.smooths, powerPreference: "high-performance" });
    this.renderer.outputColorSpace = SRGBColorSpace;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = this.sharpness.smooths ? PCFShadowMap : BasicShadowMap;
    this.renderer.shadowMap.autoUpdate = false;
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(32, 1, 0.1, 900);
    this.camera.up.set(0, 1, 0);
    // Ground axes have Z down and Y uphill; three's have y up.
    this.frame = new Group();
    this.frame.rotation.x = Math.PI / 2;
    this.scene.add(this.frame);
    this.hemisphere = new HemisphereLight(0xffffff, 0x8a8272, 1);
    this.sun = new DirectionalLight(0xfff6e8, 2);
    this.sun.castShadow = true;
    const shadows = this.sharpness.smooths ? 1024 : 512;
    this.sun.shadow.mapSize.set(shadows, shadows);
    this.sun.shadow.radius = 3;
    this.sun.shadow.normalBias = 0.03;
    this.scene.add(this.hemisphere, this.sun, this.sun.target);
    this.size = 1;
    this.controls = new OrbitControls(this.camera, canvas);
    // A finger that goes up or down scrolls the page.
    canvas.style.touchAction = "pan-y";
    this.controls.minDistance = 1;
    this.controls.maxDistance = 300;
    this.controls.addEventListener("change", () => this.draw());
    this.isWanted = false;
    /** Whether pictures keep their size, as those of a recording must. */
    this.keepsSize = false;
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    this.later = undefined;
    this.ratio = 0;
    /** How much coarser pictures are while something moves, and what tells: when the last one was, and the mean interval, ms. */
    this.pace = 1;
    this.last = 0;
    this.interval = 0;
    this.followed = new Vector3();
    new ResizeObserver(() => this.fit()).observe(canvas.parentElement ?? canvas);
    this.recolour();
  }

  /** Takes the colours in force. */
  recolour() {
    const { scene } = colours();
    this.scene.background = new Color(scene.sky);
    this.hemisphere.intensity = scene.ambient;
    this.sun.intensity = scene.shine;
    this.fog();
    this.draw();
  }

  fog() {
    this.scene.fog = new Fog(colours().scene.haze, 3.2 * this.size, 11 * this.size);
  }

  /** Takes the size of its place. */
  fit() {
    const { clientWidth, clientHeight } = this.canvas.parentElement ?? this.canvas;
    if (clientWidth < 2 || clientHeight < 2) return;
    this.sharpness = { ...sharpness(), smooths: this.sharpness.smooths };
    this.ratio = 0;
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  /** Sizes lights, haze and the distance of the camera for a lander so many ft across. @param {number} size */
  resize(size) {
    const arm = this.camera.position.clone().sub(this.controls.target);
    this.camera.position.copy(this.controls.target).addScaledVector(arm, size / this.size);
    this.size = size;
    const reach = 1.1 * size;
    const { camera } = this.sun.shadow;
    Object.assign(camera, { left: -reach, right: reach, top: reach, bottom: -reach, near: 0.1, far: 6 * size });
    camera.updateProjectionMatrix();
    this.fog();
  }

  /** Looks from one of the named views. @param {View} view @param {Vector3} at in ground axes */
  look(view, at) {
    const target = this.frame.localToWorld(at.clone());
    const from = new Vector3(...VIEWS[view]).multiplyScalar(this.size * (this.camera.aspect < 1 ? 1 / this.camera.aspect : 1));
    this.controls.target.copy(target);
    this.camera.position.copy(this.frame.localToWorld(at.clone().add(from)));
    this.followed.copy(target);
    this.controls.update();
    this.draw();
  }

  /** Moves lights, and the camera if it follows, with a point. @param {Vector3} at in ground axes @param {boolean} isFollowing */
  follow(at, isFollowing) {
    const target = this.frame.localToWorld(at.clone());
    if (isFollowing) {
      const moved = target.clone().sub(this.followed);
      this.controls.target.add(moved);
      this.camera.position.add(moved);
    }
    this.followed.copy(target);
    this.sun.target.position.copy(target);
    this.sun.position.copy(target).add(new Vector3(0.9, 2.2, 0.7).multiplyScalar(this.size));
    this.renderer.shadowMap.needsUpdate = true;
  }

  /** Wants a picture with the next frame. */
  draw() {
    if (this.isWanted) return;
    this.isWanted = true;
    requestAnimationFrame((now) => {
      this.isWanted = false;
      const { still } = this.sharpness;
      if (!this.keepsSize) this.#keepPace(now);
      const moving = this.pace * this.sharpness.moving;
      this.#render(moving);
      clearTimeout(this.later);
      if (still > moving && !this.keepsSize) this.later = setTimeout(() => this.render(), STILL);
    });
  }

  /** Pictures that come too slowly while something moves become coarser. @param {number} now ms */
  #keepPace(now) {
    const passed = now - this.last;
    this.last = now;
    if (passed > 500) return;
    this.interval += 0.12 * (passed - this.interval);
    if (this.interval < SLOW || this.pace <= COARSEST) return;
    this.pace = Math.max(0.8 * this.pace, COARSEST);
    this.interval = 0;
  }

  /** Draws at once, as fine as can be. */
  render() {
    this.#render(this.sharpness.still);
  }

  /** @param {number} ratio pixels of the picture for one of the screen */
  #render(ratio) {
    if (ratio !== this.ratio) {
      const { clientWidth, clientHeight } = this.canvas.parentElement ?? this.canvas;
      if (clientWidth < 2 || clientHeight < 2) return;
      this.ratio = ratio;
      this.renderer.setPixelRatio(ratio);
      this.renderer.setSize(clientWidth, clientHeight, false);
    }
    this.renderer.render(this.scene, this.camera);
  }
}
