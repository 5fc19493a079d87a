/** Marks of points, as our pictures have them. */

/** A triangle: no transition. @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {number} half @param {string} colour */
export function openTriangle(context, x, y, half, colour) {
  context.beginPath();
  context.moveTo(x, y - half);
  context.lineTo(x + half, y + 0.75 * half);
  context.lineTo(x - half, y + 0.75 * half);
  context.closePath();
  context.strokeStyle = colour;
  context.lineWidth = 1.3;
  context.stroke();
}

/** @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {number} radius @param {string} colour */
export function disc(context, x, y, radius, colour) {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fillStyle = colour;
  context.fill();
}

/** @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {number} radius @param {string} colour */
export function ring(context, x, y, radius, colour) {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.strokeStyle = colour;
  context.lineWidth = 1.5;
  context.stroke();
}

/** A crosshair at what is chosen. @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {string} colour @param {string} halo */
export function crosshair(context, x, y, colour, halo) {
  for (const [width, style] of /** @type {[number, string][]} */ ([[5, halo], [2, colour]])) {
    context.lineWidth = width;
    context.strokeStyle = style;
    context.beginPath();
    context.arc(x, y, 8, 0, 2 * Math.PI);
    for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
      context.moveTo(x + 5 * dx, y + 5 * dy);
      context.lineTo(x + 13 * dx, y + 13 * dy);
    }
    context.stroke();
  }
}
