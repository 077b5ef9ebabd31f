// The strip on top: how many vehicles are dead, silent, failing, low or warned, which, and how badly; the worst first.
// @ts-check
import { h, say, vehicles } from "./elements.js";
import { SIGNS } from "./signs.js";

/** @typedef {import("./messages").SnapshotMessage} Snapshot */
/** @typedef {import("./messages").VehicleRow} VehicleRow */
/** @typedef {{name: string, title: string, unit: string}} Condition */

const MOST_FIGURES = 14;

/** The conditions of gcs/telemetry/health.py, the worst first. @type {Condition[]} */
let conditions = [];

/** @param {Condition[]} given */
export function useConditions(given) {
  conditions = given;
}

/** The place of a vehicle's condition, the worst first; those that are well come last. @param {VehicleRow} row */
export function rank(row) {
  const k = conditions.findIndex((one) => one.name === row.condition);
  return k < 0 ? conditions.length : k;
}

/** `5 (48 s left), 4 (50 s)`. @param {VehicleRow[]} rows @param {string} unit what the first figure says more */
function figures(rows, unit) {
  const told = rows.slice(0, MOST_FIGURES).map((row, k) => `${row.sysid}${row.figure ? ` (${row.figure}${k || !unit ? "" : ` ${unit}`})` : ""}`);
  return told.join(", ") + (rows.length > MOST_FIGURES ? ` and ${rows.length - MOST_FIGURES} more` : "");
}

export class Strip {
  /** @param {(sysids: number[]) => void} select */
  constructor(select) {
    this.well = h("p", { class: "well" });
    /** whether what is shown may no longer be so: nothing is said to be well then */
    this.stale = false;
    /** @type {Map<string, {item: HTMLElement, button: HTMLElement, count: HTMLElement, text: HTMLElement, sysids: number[]}>} */
    this.parts = new Map();
    const list = h("ul");
    for (const { name, title } of conditions) {
      const [count, text] = [h("b"), h("span", { class: "figures-of" })];
      const button = h("button", { type: "button", onclick: () => select(this.parts.get(name)?.sysids ?? []) },
        h("span", { class: "sign", "aria-hidden": "true" }, SIGNS[name] ?? ""), count, text);
      const item = h("li", { class: name, "data-condition": name, "data-title": title }, button);
      item.hidden = true;
      list.append(item);
      this.parts.set(name, { item, button, count, text, sysids: [] });
    }
    // Figures change each second: only counts are read out.
    this.counts = h("p", { class: "unseen", "aria-live": "polite" });
    this.all = h("div", { class: "all" });
    this.element = h("section", { class: "strip", "aria-label": "trouble" }, this.well, list, this.all, this.counts);
  }

  /** @param {Snapshot} snapshot */
  show(snapshot) {
    const counts = [];
    for (const { name, title, unit } of conditions) {
      const part = this.parts.get(name);
      if (!part) continue;
      const rows = snapshot.vehicles.filter((row) => row.condition === name).sort((a, b) => b.urgency - a.urgency || a.sysid - b.sysid);
      part.sysids = rows.map((row) => row.sysid);
      if (part.item.hidden !== !rows.length) part.item.hidden = !rows.length;
      if (!rows.length) continue;
      const text = `${title}: ${figures(rows, unit)}`;
      say(part.count, String(rows.length));
      say(part.text, text);
      part.button.title = `${text}. Click to select.`;
      counts.push(`${rows.length} ${title.toLowerCase()}`);
    }
    const armed = snapshot.vehicles.filter((row) => row.armed).length;
    const well = counts.length || this.stale ? "" : `All well · ${vehicles(snapshot.vehicles.length)}, ${armed} armed`;
    if (this.well.hidden !== !well) this.well.hidden = !well;
    say(this.well, well);
    say(this.counts, counts.join(", "));
  }
}
