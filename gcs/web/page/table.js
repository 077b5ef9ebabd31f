// The fleet as a table, trouble first: filter, totals by state, a histogram of the batteries, and go-to by id.
// @ts-check
import { h, number, say, vehicles } from "./elements.js";
import { colourOf } from "./look.js";
import { modeOf, signOf } from "./signs.js";
import { rank } from "./strip.js";

/** @typedef {import("./messages").VehicleRow} VehicleRow */
/** @typedef {import("./messages").SnapshotMessage} Snapshot */

const BINS = 10;

/**
 * `folds`: where the table is narrow its text stands in the second column, under the trouble.
 * @type {{key: string, name: string, word?: boolean, folds?: boolean, text: (row: VehicleRow) => string, sort: (row: VehicleRow) => number | string}[]}
 */
const COLUMNS = [
  { key: "id", name: "id", text: (row) => String(row.sysid), sort: (row) => row.sysid },
  { key: "trouble", name: "trouble", word: true, text: (row) => row.trouble.join(", ") || row.note || (row.landed ? "landed" : ""), sort: (row) => rank(row) + (row.condition || row.landed ? 0 : 0.5) },
  { key: "state", name: "state", word: true, folds: true, text: (row) => row.state || (row.alive ? "–" : "lost"), sort: (row) => row.state },
  { key: "mode", name: "mode", word: true, folds: true, text: (row) => modeOf(row) || "–", sort: modeOf },
  { key: "role", name: "role", word: true, folds: true, text: (row) => row.role, sort: (row) => row.role },
  { key: "battery", name: "battery %", text: (row) => number(row.battery === null ? null : 100 * row.battery, 0), sort: (row) => row.battery ?? -1 },
  { key: "height", name: "height m", text: (row) => number(row.height_m, 1), sort: (row) => row.height_m ?? -1e9 },
  { key: "speed", name: "speed m/s", text: (row) => number(row.speed_m_s, 1), sort: (row) => row.speed_m_s ?? -1 },
  { key: "target", name: "target m", text: (row) => number(row.target_m, 1), sort: (row) => row.target_m ?? -1 },
];
const FOLDED = COLUMNS.filter((column) => column.folds);

/** @param {typeof COLUMNS[number]} column */
const classOf = (column) => [column.word && "word", column.folds && "folds", column.key === "trouble" && "trouble"].filter(Boolean).join(" ");

export class FleetTable {
  /** @param {HTMLElement} parent @param {(sysid: number | null, go: boolean, event?: MouseEvent | KeyboardEvent) => void} choose */
  constructor(parent, choose) {
    this.choose = choose;
    this.by = "trouble";
    this.down = false;
    /** @type {Map<number, {row: HTMLTableRowElement, texts: HTMLElement[], sign: HTMLElement, folded: HTMLElement, swatch: HTMLElement, colour: string}>} */
    this.rows = new Map();
    this.filter = h("input", { type: "search", placeholder: "filter, e.g. tanker, served, 12", "aria-label": "filter vehicles", oninput: () => this.again() });
    this.goto = h("input", { type: "text", inputmode: "numeric", size: 4, placeholder: "id", "aria-label": "go to vehicle" });
    const form = h("form", { class: "goto", onsubmit: (/** @type {Event} */ event) => {
      event.preventDefault();
      const sysid = Number(this.goto.value);
      if (this.rows.has(sysid)) choose(sysid, true);
      this.goto.setCustomValidity(this.rows.has(sysid) ? "" : "There is no such vehicle.");
      this.goto.reportValidity();
    } }, this.goto, h("button", { type: "submit" }, "go to"));
    this.goto.addEventListener("input", () => this.goto.setCustomValidity(""));
    this.totals = h("p", { class: "totals small", "aria-live": "off" });
    this.histogram = h("div", { class: "histogram", role: "img", "aria-label": "batteries: not known yet" });
    this.heads = COLUMNS.map((column) => {
      const button = h("button", { type: "button", onclick: () => this.sortBy(column.key) }, column.name);
      return h("th", { scope: "col", class: classOf(column) }, button);
    });
    this.body = h("tbody");
    const table = h("table", { class: "fleet" }, h("thead", {}, h("tr", {}, ...this.heads)), this.body);
    parent.append(
      h("div", { class: "tools" }, this.filter, form), this.totals, this.histogram,
      h("div", { class: "scroll fleet-scroll", tabindex: 0, role: "region", "aria-label": "vehicles" }, table),
    );
    this.sortBy("trouble", false);
  }

  /** @param {string} key */
  sortBy(key, turn = true) {
    this.down = turn && this.by === key && !this.down;
    this.by = key;
    this.heads.forEach((head, k) => {
      if (COLUMNS[k].key === key) head.setAttribute("aria-sort", this.down ? "descending" : "ascending");
      else head.removeAttribute("aria-sort");
    });
    this.again();
  }

  again() {
    if (this.last) this.show(this.last.snapshot, this.last.chosen, this.last.picked);
  }

  /** @param {Snapshot} snapshot @param {number | null} chosen @param {Set<number>} picked */
  show(snapshot, chosen, picked) {
    const changed = this.last?.picked !== picked;
    this.last = { snapshot, chosen, picked };
    const wanted = this.filter.value.trim().toLowerCase();
    const column = COLUMNS.find((one) => one.key === this.by) ?? COLUMNS[0];
    const rows = [...snapshot.vehicles].sort((a, b) => {
      const [x, y] = [column.sort(a), column.sort(b)];
      const order = x < y ? -1 : x > y ? 1 : a.sysid - b.sysid;
      return this.down ? -order : order;
    });
    const place = [];
    for (const row of rows) {
      const one = this.rows.get(row.sysid) ?? this.#make(row);
      COLUMNS.forEach((col, k) => say(one.texts[k], col.text(row)));
      say(one.sign, signOf(row));
      say(one.folded, FOLDED.map((col) => col.text(row)).filter((text) => text !== "–").join(" · "));
      const colour = colourOf(row.sysid);
      if (one.colour !== colour) one.swatch.style.background = one.colour = colour;
      const text = `${row.sysid} ${row.role} ${row.label} ${row.state} ${row.mode} ${row.mode_name} ${row.note} ${row.trouble.join(" ")}`.toLowerCase();
      const hidden = wanted !== "" && !wanted.split(/\s+/).every((word) => (/^\d+$/.test(word) ? String(row.sysid).startsWith(word) : text.includes(word)));
      if (one.row.hidden !== hidden) one.row.hidden = hidden;
      const selected = String(picked.has(row.sysid));
      if (one.row.getAttribute("aria-selected") !== selected) one.row.setAttribute("aria-selected", selected);
      if (one.row.className !== row.condition) one.row.className = row.condition;
      place.push(one.row);
    }
    if (place.some((row, k) => this.body.children[k] !== row) || this.body.children.length !== place.length) this.body.replaceChildren(...place);
    this.#total(snapshot);
    if (changed && chosen !== null) this.rows.get(chosen)?.row.scrollIntoView({ block: "nearest" });
  }

  /** Vehicles that the filter lets through, as they stand in the table. */
  get shown() {
    return [...this.rows].filter(([, one]) => !one.row.hidden).sort(([, a], [, b]) => a.row.rowIndex - b.row.rowIndex).map(([sysid]) => sysid);
  }

  /** Vehicles from one to another as they stand in the table; null for a click elsewhere. @param {number} from @param {number} to @param {MouseEvent | KeyboardEvent} event */
  between(from, to, event) {
    if (!(event.target instanceof Node && this.body.contains(event.target))) return null;
    const { shown } = this;
    const [a, b] = [shown.indexOf(from), shown.indexOf(to)].sort((x, y) => x - y);
    return a < 0 ? null : shown.slice(a, b + 1);
  }

  /** @param {VehicleRow} row */
  #make(row) {
    const swatch = h("i", { class: "swatch" });
    const sign = h("span", { class: "sign", "aria-hidden": "true" });
    const folded = h("small", { class: "folded" });
    const texts = COLUMNS.map((column, k) => (k ? h("span") : h("button", { type: "button", class: "link" })));
    const cells = COLUMNS.map((column, k) => {
      const beside = { id: [swatch], trouble: [sign] }[column.key] ?? [];
      return h("td", { class: classOf(column) }, ...beside, texts[k], column.key === "trouble" ? folded : null);
    });
    const choose = (/** @type {MouseEvent | KeyboardEvent} */ event) => this.choose(row.sysid, false, event);
    const withKeys = (/** @type {KeyboardEvent} */ event) => {
      if (event.key !== "Enter" || !(event.shiftKey || event.ctrlKey || event.metaKey)) return; // a button's own click knows no modifiers
      event.preventDefault();
      choose(event);
    };
    const made = { row: h("tr", { onclick: choose, onkeydown: withKeys }, ...cells), texts, sign, folded, swatch, colour: "" };
    this.rows.set(row.sysid, made);
    return made;
  }

  /** @param {Snapshot} snapshot */
  #total(snapshot) {
    /** @type {Map<string, number>} */
    const counts = new Map();
    const bins = new Array(BINS).fill(0);
    for (const row of snapshot.vehicles) {
      const state = modeOf(row) || row.state || "unknown";
      counts.set(state, (counts.get(state) ?? 0) + 1);
      if (row.battery !== null && Number.isFinite(row.battery)) bins[Math.min(Math.max(Math.floor(BINS * row.battery), 0), BINS - 1)] += 1;
    }
    const told = [...counts].sort((a, b) => b[1] - a[1]).map(([state, count]) => `${count} ${state}`);
    say(this.totals, `${vehicles(snapshot.vehicles.length)}: ${told.join(", ")}`);
    const most = Math.max(...bins, 1);
    while (this.histogram.children.length < BINS) this.histogram.append(h("span"));
    bins.forEach((count, k) => {
      const bar = /** @type {HTMLElement} */ (this.histogram.children[k]);
      bar.style.height = `${(100 * count) / most}%`;
      bar.title = `${count} with ${10 * k} to ${10 * k + 10} %`;
      bar.className = k < 2 ? "low" : "";
    });
    const low = bins[0] + bins[1];
    this.histogram.setAttribute("aria-label", `batteries, by tenths from empty to full: ${bins.join(", ")}; ${low} below 20 %`);
  }
}
