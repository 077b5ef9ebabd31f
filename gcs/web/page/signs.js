// Signs of a vehicle's state, told by their shape: the same in strip, table, map and space.
// @ts-check

/** In text. @type {Record<string, string>} */
export const SIGNS = { dead: "✕", silent: "⌀", failing: "▲", low: "◔", warned: "△", landed: "▼" };
