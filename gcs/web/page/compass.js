// Where north is, over a picture.
// @ts-check
import { look } from "./look.js";

/** @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {number} turned_rad clockwise from up */
export function drawNorth(context, x, y, turned_rad) {
  context.save();
  context.fillStyle = look().ink;
  context.translate(x, y);
  context.rotate(turned_rad);
  context.beginPath();
  [[0, -14], [5, 0], [0, -4], [-5, 0]].forEach(([u, w], k) => context[k ? "lineTo" : "moveTo"](u, w));
  context.fill();
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.font = "700 13px system-ui, sans-serif";
  context.translate(0, 10);
  context.rotate(-turned_rad);
  context.fillText("N", 0, 0);
  context.restore();
}
