import { BufferGeometry, Float32BufferAttribute, Vector3 } from "../vendor/three.js";

/** Corners of the rim of a patch. */
const CORNERS = 36;
/** How far its flank goes outward, of its height. */
const FLANK = 0.5;

/**
 * A patch of ground that is not the surface, such as a rock or the bottom of a pit, with its flank down or up to the surface.
 * @param {Vector3} point its middle
 * @param {Vector3} normal unit vector, up
 * @param {number} radius ft
 * @param {{ normal: Vector3, at: Vector3 }} surface
 * @returns {{ geometry: BufferGeometry, foot: Vector3, hole: number }} with the point of the surface below or above its middle,
 *   and the radius of the hole that shows it there; 0 where it lies above the surface
 */
export function patchOf(point, normal, radius, surface) {
  const height = (/** @type {Vector3} */ at) => at.clone().sub(surface.at).dot(surface.normal);
  const onSurface = (/** @type {Vector3} */ at) => at.clone().addScaledVector(surface.normal, -height(at));
  const foot = onSurface(point);
  const aside = Math.abs(normal.x) < 0.9 ? new Vector3(1, 0, 0) : new Vector3(0, 1, 0);
  const u = aside.addScaledVector(normal, -aside.dot(normal)).normalize();
  const v = new Vector3().crossVectors(normal, u);
  const spread = 1 + (FLANK * Math.abs(height(point))) / radius;
  const rims = Array.from({ length: CORNERS + 1 }, (_, index) => {
    const angle = (2 * Math.PI * (index % CORNERS)) / CORNERS;
    const rim = point.clone().addScaledVector(u, radius * Math.cos(angle)).addScaledVector(v, radius * Math.sin(angle));
    return { rim, base: onSurface(rim).sub(foot).multiplyScalar(spread).add(foot) };
  });
  const corners = rims.slice(1).flatMap((next, index) => {
    const here = rims[index];
    return [point, here.rim, next.rim, here.rim, here.base, next.base, here.rim, next.base, next.rim];
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(corners.flatMap((corner) => corner.toArray()), 3));
  geometry.computeVertexNormals();
  const isBelow = rims.some(({ rim }) => height(rim) < -1e-3 * radius);
  const hole = isBelow ? Math.min(...rims.map(({ base }) => base.distanceTo(foot))) : 0;
  return { geometry, foot, hole };
}
