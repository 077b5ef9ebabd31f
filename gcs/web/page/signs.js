// Signs of a vehicle's state, told by their shape: the same in strip, table, map and space.
// @ts-check

/** @typedef {import("./messages").VehicleRow} VehicleRow */

/** In text. @type {Record<string, string>} */
export const SIGNS = { dead: "✕", silent: "⌀", failing: "▲", low: "◔", warned: "△", landed: "▼" };

/** The sign of what matters most of a vehicle: its trouble, else that it has landed. @param {VehicleRow} row */
export const signOf = (row) => SIGNS[row.condition || (row.landed ? "landed" : "")] ?? "";
