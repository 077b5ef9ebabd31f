// Colours and themes: one colour per vehicle by its place in the scenario, the same as in console, report and plan.
// @ts-check

/** @typedef {{light: string[], dark: string[], sources: {light: string[], dark: string[]}, alarm: {light: string, dark: string}}} Palette */
/** @typedef {{dark: boolean, ink: string, soft: string, grid: string, paper: string, faint: string, solid: string, band: string, crowd: string, bad: string, warn: string, good: string}} Look */

const darkly = matchMedia("(prefers-color-scheme: dark)");
/** @type {Palette} */
let palette = { light: ["#000"], dark: ["#fff"], sources: { light: [], dark: [] }, alarm: { light: "#000", dark: "#fff" } };
/** @type {Map<number, {index: number, role: string}>} */
const members = new Map();
let printing = false;
/** @type {Set<() => void>} */
const listeners = new Set();

/** @param {Palette} given */
export function usePalette(given) {
  palette = given;
}

/** @param {{sysid: number, role: string, colour: number}[]} rows */
export function setMembers(rows) {
  members.clear();
  for (const row of rows) members.set(row.sysid, { index: row.colour, role: row.role });
}

/** @param {() => void} listener called when light turns to dark or back */
export function onLook(listener) {
  listeners.add(listener);
}
const tell = () => listeners.forEach((listener) => listener());
darkly.addEventListener("change", tell);

/** @param {boolean} on on paper everything is dark on white */
export function setPrinting(on) {
  printing = on;
  tell();
}

/** @returns {"auto" | "light" | "dark"} */
export function theme() {
  const chosen = document.documentElement.dataset.theme;
  return chosen === "light" || chosen === "dark" ? chosen : "auto";
}

export function nextTheme() {
  const next = isDark() ? "light" : "dark";
  document.documentElement.dataset.theme = next;
  try {
    localStorage.setItem("skytender-theme", next);
  } catch {
    // a file opened from disk may keep nothing
  }
  tell();
}

export function restoreTheme() {
  try {
    const kept = localStorage.getItem("skytender-theme");
    if (kept === "light" || kept === "dark") document.documentElement.dataset.theme = kept;
  } catch {
    // as above
  }
}

export function isDark() {
  if (printing) return false;
  const chosen = theme();
  return chosen === "auto" ? darkly.matches : chosen === "dark";
}

/** @returns {Look} */
export function look() {
  return isDark()
    ? { dark: true, ink: "#e6e9ed", soft: "#a3adb8", grid: "#2b323a", paper: "#12161b", faint: "#1d232a", solid: "#7d8894",
        band: "rgba(86,180,233,.25)", crowd: "rgba(163,173,184,.35)", bad: "#ff9d7a", warn: "#f0c860", good: "#5fd3ac" }
    : { dark: false, ink: "#1b1f24", soft: "#57606a", grid: "#dfe4e9", paper: "#ffffff", faint: "#f3f5f7", solid: "#6b7682",
        band: "rgba(0,114,178,.18)", crowd: "rgba(87,96,106,.3)", bad: "#a52a00", warn: "#7a5200", good: "#00664b" };
}

/** A vehicle's colour. Targets take the ink: they lead, and are known by their shape. @param {number} id */
export function colourOf(id) {
  const one = members.get(id);
  if (one?.role === "target") return look().ink;
  const colours = isDark() ? palette.dark : palette.light;
  return colours[(one?.index ?? id - 1) % colours.length];
}

/** Of signs that say dead, silent or failing, on a drawing: no vehicle has it. */
export const alarmColour = () => (isDark() ? palette.alarm.dark : palette.alarm.light);

/** Beyond the palette's colours, dashes tell vehicles apart. @param {number} id @returns {number[]} */
export function dashOf(id) {
  const one = members.get(id);
  if (one?.role === "target") return [2, 3];
  if (one?.role === "tanker") return [8, 3];
  const count = palette.light.length;
  return [[], [6, 4], [2, 3], [6, 3, 2, 3]][Math.floor((one?.index ?? id - 1) / count) % 4];
}

/** Colours of energy's sources and uses, which are none of the vehicles'. @param {number} k */
export function sourceColour(k) {
  const colours = isDark() ? palette.sources.dark : palette.sources.light;
  return colours[k % colours.length];
}
