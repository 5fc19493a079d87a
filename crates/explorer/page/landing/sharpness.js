/** How fine pictures are drawn. Without a graphics card finer pictures wait until nothing moves. */

/** Pixels of the picture for one of the screen, per direction. @typedef {{ moving: number, still: number, smooths: boolean }} Sharpness */

/** How long nothing moves before the finer picture is drawn, ms. */
export const STILL = 150;

/** @returns {Sharpness} */
export function sharpness() {
  const usual = Math.min(window.devicePixelRatio, 2);
  if (!isSoftware()) return { moving: usual, still: usual, smooths: true };
  // The card's smoothing of edges would cost as much as four pictures, at every frame.
  return { moving: Math.min(usual, 1), still: 1.5, smooths: false };
}

let known = /** @type {boolean | undefined} */ (undefined);

/** Whether the processor draws instead of a graphics card. */
function isSoftware() {
  if (known !== undefined) return known;
  const context = document.createElement("canvas").getContext("webgl2");
  const info = context?.getExtension("WEBGL_debug_renderer_info");
  const name = context && info ? String(context.getParameter(info.UNMASKED_RENDERER_WEBGL)) : "";
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  known = /swiftshader|llvmpipe|software|basic render/i.test(name);
  return known;
}
