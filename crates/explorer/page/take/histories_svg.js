import { colours, curveColour } from "../look/theme.js";
import { label, roundValues } from "../look/words.js";
import { SvgContext } from "./svg_context.js";

/** @typedef {import("../histories/time_chart.js").Content} Content */

const PANEL = { width: 450, height: 210 };
const ROOM = { left: 58, right: 14, top: 38, bottom: 26 };

/** The panels of histories as one picture, two beside each other. @param {Content[]} contents */
export function historiesSvg(contents) {
  const rows = Math.ceil(contents.length / 2);
  const svg = new SvgContext(2 * PANEL.width, rows * PANEL.height);
  svg.fillStyle = colours().paper;
  svg.fillRect(0, 0, svg.width, svg.height);
  contents.forEach((content, index) => drawPanel(svg, content, (index % 2) * PANEL.width, Math.floor(index / 2) * PANEL.height));
  return svg.toString();
}

/** @param {SvgContext} svg @param {Content} content @param {number} left @param {number} top */
function drawPanel(svg, { title, unit, times, curves, bands }, left, top) {
  const now = colours();
  const values = curves.flatMap((curve) => curve.values.filter((value) => value !== null));
  const [low, high] = values.reduce(([l, h], value) => [Math.min(l, value), Math.max(h, value)], [Infinity, -Infinity]);
  const margin = 0.06 * (high - low) || 1;
  const [from, to, end] = [low - margin, high + margin, times[times.length - 1] || 1];
  const [width, height] = [PANEL.width - ROOM.left - ROOM.right, PANEL.height - ROOM.top - ROOM.bottom];
  const x = (/** @type {number} */ time) => left + ROOM.left + (time / end) * width;
  const y = (/** @type {number} */ value) => top + ROOM.top + (1 - (value - from) / (to - from)) * height;
  svg.globalAlpha = 1;
  svg.lineWidth = 1;
  svg.strokeStyle = now.grid;
  svg.fillStyle = now.text;
  svg.font = "11px";
  svg.textAlign = "center";
  svg.textBaseline = "top";
  for (const time of roundValues(0, end, 8)) {
    svg.strokeRect(x(time), top + ROOM.top, 0, height);
    svg.fillText(label(time), x(time), top + ROOM.top + height + 6);
  }
  svg.textAlign = "right";
  svg.textBaseline = "middle";
  for (const value of roundValues(from, to, 5)) {
    svg.strokeRect(left + ROOM.left, y(value), width, 0);
    svg.fillText(label(value), left + ROOM.left - 6, y(value));
  }
  svg.textAlign = "left";
  svg.font = "12px";
  svg.fillText(unit ? `${title}, ${unit}` : title, left + ROOM.left, top + 12);
  const trace = (/** @type {(number | null)[]} */ list, isBack = false) => {
    const order = isBack ? [...list.keys()].reverse() : [...list.keys()];
    let isOpen = !isBack;
    for (const instant of order) {
      const value = list[instant];
      if (value === null) continue;
      if (isOpen) svg.moveTo(x(times[instant]), y(value));
      else svg.lineTo(x(times[instant]), y(value));
      isOpen = false;
    }
  };
  for (const { series, fill } of bands ?? []) {
    svg.beginPath();
    trace(curves[series[0] - 1].values);
    trace(curves[series[1] - 1].values, true);
    svg.closePath();
    svg.fillStyle = fill.slice(0, 7);
    svg.globalAlpha = 0.4;
    svg.fill();
  }
  svg.globalAlpha = 1;
  let at = left + ROOM.left;
  svg.font = "10px";
  for (const [index, curve] of curves.entries()) {
    const colour = curve.colour ?? curveColour(index);
    if (!curve.name) continue;
    svg.strokeStyle = svg.fillStyle = colour;
    svg.lineWidth = curve.width ?? 1.6;
    svg.setLineDash(curve.dash ?? []);
    svg.beginPath();
    trace(curve.values);
    svg.stroke();
    svg.setLineDash([]);
    svg.fillText(curve.name, at, top + 27);
    at += svg.measureText(curve.name).width + 12;
  }
}
