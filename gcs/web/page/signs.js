// Signs of a vehicle's state, distinguished by shape: the same in strip, table, map and space.
// @ts-check
import { alarmColour, look } from "./look.js";

/** @typedef {import("./messages").VehicleRow} VehicleRow */

/** In text. @type {Record<string, string>} */
export const SIGNS = { dead: "✕", silent: "⌀", failing: "▲", low: "◔", warned: "△", landed: "▼" };

/** The sign of what matters most of a vehicle: its trouble, else that it has landed. @param {VehicleRow} row */
export const signOf = (row) => SIGNS[row.condition || (row.landed ? "landed" : "")] ?? "";

/** A vehicle's flight mode, or that it is dead, as in the console (gcs/console/pages/fleet.py). @param {VehicleRow} row */
export const modeOf = (row) => (row.alive ? row.mode_name : "DEAD");

const HALO = 3;
const TURN = 2 * Math.PI;

/** @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {number} r @param {number} up 1 points up, -1 down */
function triangle(context, x, y, r, up) {
  context.beginPath();
  context.moveTo(x, y - 0.8 * up * r);
  context.lineTo(x + r, y + 0.8 * up * r);
  context.lineTo(x - r, y + 0.8 * up * r);
  context.closePath();
}

/**
 * Draw a vehicle's state at its place: dead crossed out, silent struck through in a circle, failing a full triangle above
 * it, warned an empty one, low a ring of its charge; and below it a triangle that points down once it has landed.
 * @param {CanvasRenderingContext2D} context @param {VehicleRow} row @param {number} x @param {number} y @param {number} size half a vehicle's width
 */
export function drawSign(context, row, x, y, size) {
  const { ink, paper, soft } = look();
  const [r, wide] = [1.5 * size, Math.max(0.35 * size, 2)];
  context.setLineDash([]);
  /** @param {string} colour @param {number} width */
  const stroke = (colour, width) => {
    for (const [tint, thick] of /** @type {[string, number][]} */ ([[paper, width + HALO], [colour, width]])) {
      context.strokeStyle = tint;
      context.lineWidth = thick;
      context.stroke();
    }
  };
  /** @param {string} inside @param {string} edge */
  const fill = (inside, edge) => {
    stroke(edge, 0.75 * wide);
    context.fillStyle = inside;
    context.fill();
  };
  if (row.condition === "dead" || row.condition === "silent") {
    const k = 0.75 * r;
    context.beginPath();
    if (row.condition === "silent") {
      context.arc(x, y, r, 0, TURN);
    } else {
      context.moveTo(x - k, y - k);
      context.lineTo(x + k, y + k);
    }
    context.moveTo(x - k, y + k);
    context.lineTo(x + k, y - k);
    stroke(alarmColour(), wide);
  } else if (row.condition === "failing" || row.condition === "warned") {
    const full = row.condition === "failing";
    triangle(context, x, y - 2.3 * size, (full ? 1.3 : 0.9) * size, 1);
    fill(full ? alarmColour() : paper, full ? alarmColour() : ink);
  } else if (row.condition === "low") {
    context.beginPath();
    context.arc(x, y, 1.1 * r, 0, TURN);
    stroke(soft, 1);
    context.beginPath();
    context.arc(x, y, 1.1 * r, -TURN / 4, TURN * (Math.min(Math.max(row.battery ?? 0, 0.02), 1) - 0.25));
    stroke(ink, 1.3 * wide);
  }
  if (row.landed && row.condition !== "dead") {
    triangle(context, x, y + 2.2 * size, 0.9 * size, -1);
    fill(ink, ink);
  }
}
