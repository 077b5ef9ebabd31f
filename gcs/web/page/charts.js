// Figures over time, drawn by uPlot. All share one zoom, one pointer, and the time that the fleet is shown at.
// @ts-check
import uPlot from "uplot";
import { h, number } from "./elements.js";
import { colourOf, dashOf, look, sourceColour } from "./look.js";

/**
 * @typedef {{id?: number, label?: string, x: ArrayLike<number>, y: ArrayLike<number>}} Line
 * @typedef {{title: string, unit: string, digits: number, zero?: boolean, range?: [number, number] | null,
 *   limits: {y: number, label: string}[], lines: Line[], own: Line[], ghosts?: Line[],
 *   band?: {least: Line, median: Line, greatest: Line, count: number}}} Panel
 * @typedef {{t_s: number, id?: number, label: string, text?: string, bad?: boolean}} Mark
 * @typedef {{from: number, to: number, id: number}} Span
 * @typedef {Pick<SharedTime, "range" | "zoom" | "now_s" | "begin_s" | "end_s" | "charts" | "setZoom" | "seek" | "point">} Time
 * @typedef {{panels: Panel[], marks: Mark[], spans: Span[]}} Figure
 */

const PANEL_PX = 165;
const AXIS_PX = 52;
const MOST_VALUES = 9;
const SECONDS = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000, 20000, 50000];

/** What all figures share: the zoom, and the time at which the fleet is shown. */
export class SharedTime {
  constructor() {
    /** @type {[number, number] | null} */
    this.zoom = null;
    this.now_s = 0;
    this.end_s = 1;
    this.begin_s = 0;
    /** @type {Set<TimeChart>} */
    this.charts = new Set();
    /** @type {(t_s: number) => void} */
    this.seek = () => {};
    /** @type {(t_s: number | null) => void} */
    this.point = () => {};
  }

  /** @returns {[number, number]} */
  get range() {
    return this.zoom ?? [this.begin_s, Math.max(this.end_s, this.begin_s + 1e-3)];
  }

  /** @param {[number, number] | null} zoom */
  setZoom(zoom) {
    this.zoom = zoom;
    const [min, max] = this.range;
    for (const chart of this.charts) for (const plot of chart.plots) plot.setScale("x", { min, max });
  }

  /** @param {number} now_s */
  setNow(now_s) {
    if (this.now_s === now_s) return;
    this.now_s = now_s;
    for (const chart of this.charts) chart.showNow();
  }
}

/** Zoom all figures around the time that is shown. @param {Time} time @param {number} by less than 1: nearer */
function zoomBy(time, by) {
  const [begin_s, end_s] = time.range;
  const [least_s, most_s] = [time.begin_s, Math.max(time.end_s, time.begin_s + 1e-3)];
  const span_s = Math.max(by * (end_s - begin_s), SECONDS[0]);
  if (span_s >= most_s - least_s) return time.setZoom(null);
  const middle_s = time.now_s >= begin_s && time.now_s <= end_s ? time.now_s : (begin_s + end_s) / 2;
  const from_s = Math.min(Math.max(middle_s - span_s / 2, least_s), most_s - span_s);
  time.setZoom([from_s, from_s + span_s]);
}

/** NaN becomes a gap. @param {ArrayLike<number>} values @returns {(number | null)[]} */
function gaps(values) {
  return Array.from(values, (value) => (Number.isNaN(value) ? null : value));
}

export class TimeChart {
  /** @param {HTMLElement} div @param {Time} time @param {(id: number) => string} label */
  constructor(div, time, label) {
    this.div = div;
    this.time = time;
    this.label = label;
    /** @type {uPlot[]} */
    this.plots = [];
    this.key = "";
    /** @type {{min: number, max: number}[]} what each plot shows of its values, whatever the zoom */
    this.ranges = [];
    /** @type {Figure | null} */
    this.figure = null;
    /** @type {HTMLElement[]} */
    this.nows = [];
    time.charts.add(this);
    div.tabIndex = 0;
    div.setAttribute("aria-keyshortcuts", "+ - 0");
    div.addEventListener("keydown", (event) => {
      if (event.key === "+") zoomBy(time, 0.5);
      else if (event.key === "-") zoomBy(time, 2);
      else if (event.key === "0") time.setZoom(null);
      else return;
      event.preventDefault();
      event.stopPropagation();
    });
  }

  /** @param {Figure} figure @param {Set<number>} chosen */
  draw(figure, chosen, width = this.div.clientWidth) {
    if (width <= 0) return;
    this.figure = figure;
    const made = figure.panels.map((panel) => this.#content(panel, chosen));
    const key = JSON.stringify([width, look().dark, look().paper, made.map((one) => one.series.map((s) => [s.label, s.stroke, s.dash]))]);
    this.ranges = made.map((one) => one.range);
    if (key !== this.key) this.#build(made, key, width);
    this.plots.forEach((plot, k) => {
      plot.setData(/** @type {any} */ (made[k].data), false);
      const [min, max] = this.time.range;
      plot.setScale("x", { min, max });
    });
    this.div.dataset.lines = String(made.reduce((sum, one) => sum + one.series.length - 1, 0));
    this.showNow();
  }

  /** @param {Panel} panel @param {Set<number>} chosen */
  #content(panel, chosen) {
    const { soft } = look();
    /** @type {uPlot.Series[]} */
    const series = [{}];
    /** @type {any[]} */
    const tables = [];
    /** @param {Line} line @param {uPlot.Series} style */
    const add = (line, style) => {
      series.push({ spanGaps: false, points: { show: false }, width: 1.6, ...style });
      tables.push([Array.from(line.x), gaps(line.y)]);
    };
    if (panel.band) {
      add(panel.band.least, { label: "least", stroke: "transparent" });
      add(panel.band.greatest, { label: "greatest", stroke: "transparent" });
      add(panel.band.median, { label: `median of ${panel.band.count}`, stroke: soft, dash: [2, 3] });
    }
    for (const line of panel.ghosts ?? []) {
      if (chosen.has(line.id ?? -1)) add(line, { label: `(${this.label(line.id ?? -1)})`, stroke: soft, width: 1, dash: [5, 3] });
    }
    for (const line of panel.lines) {
      const id = /** @type {number} */ (line.id);
      if (chosen.has(id)) add(line, { label: this.label(id), stroke: colourOf(id), dash: dashOf(id) });
    }
    panel.own.forEach((line, k) => add(line, { label: line.label, stroke: sourceColour(k) }));
    const data = tables.length ? uPlot.join(tables) : [[this.time.begin_s, this.time.end_s]];
    let [low, high] = [Infinity, -Infinity];
    for (const [, values] of tables) for (const value of values) {
      if (value === null) continue;
      if (value < low) low = value;
      if (value > high) high = value;
    }
    for (const limit of panel.limits) {
      low = Math.min(low, limit.y);
      high = Math.max(high, limit.y);
    }
    if (panel.zero) low = Math.min(low, 0);
    if (low > high) [low, high] = [0, 1];
    const room = Math.max((high - low) * 0.06, 10 ** -panel.digits);
    const range = panel.range ? { min: panel.range[0], max: panel.range[1] } : { min: panel.zero && low >= 0 ? 0 : low - room, max: high + room };
    return { panel, series, data, range };
  }

  /** @param {{panel: Panel, series: uPlot.Series[], data: any}[]} made @param {string} key @param {number} width */
  #build(made, key, width) {
    this.key = key;
    this.close();
    this.div.replaceChildren();
    const { soft, grid, band } = look();
    made.forEach(({ panel, series }, k) => {
      const now = h("div", { class: "now" });
      const tip = h("div", { class: "tip", hidden: true });
      const heading = h("p", { class: "panel-title" }, panel.title, panel.unit ? ` (${panel.unit})` : "");
      const at = h("div", { class: "panel" });
      this.div.append(heading, at);
      const foot = k === made.length - 1;
      const font = "11px system-ui, sans-serif";
      const plot = new uPlot({
        width, height: PANEL_PX + (foot ? 18 : 0), series, legend: { show: false },
        padding: [6, 10, 0, 0],
        scales: { x: { time: false, range: (_, min, max) => [min, max] }, y: { range: () => [this.ranges[k].min, this.ranges[k].max] } },
        axes: [
          { stroke: soft, font, grid: { stroke: grid, width: 1 }, ticks: { show: false }, incrs: SECONDS, size: 22,
            label: foot ? "session time (s)" : undefined, labelFont: font, labelSize: 18, labelGap: 0 },
          { stroke: soft, font, grid: { stroke: grid, width: 1 }, ticks: { show: false }, size: AXIS_PX, space: 28 },
        ],
        bands: panel.band ? [{ series: [2, 1], fill: band }] : [],
        cursor: {
          sync: { key: "skytender", setSeries: false }, y: false, points: { show: false },
          drag: { x: true, y: false, setScale: false },
          bind: { dblclick: () => () => { this.time.setZoom(null); return null; } },
        },
        hooks: {
          drawClear: [(u) => this.#below(u)],
          draw: [(u) => this.#above(u, panel)],
          setSelect: [(u) => {
            if (u.select.width < 8) return;
            this.time.setZoom([u.posToVal(u.select.left, "x"), u.posToVal(u.select.left + u.select.width, "x")]);
            u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
          }],
          setCursor: [(u) => this.#tell(u, panel, tip)],
        },
      }, /** @type {any} */ (series.map(() => [])), at);
      plot.over.append(now, tip);
      plot.over.addEventListener("click", () => {
        if (plot.select.width < 8 && plot.cursor.left !== undefined && plot.cursor.left >= 0) this.time.seek(plot.posToVal(plot.cursor.left, "x"));
      });
      this.plots.push(plot);
      this.nows.push(now);
    });
  }

  /** Transfers as grounds. @param {uPlot} u */
  #below(u) {
    const { ctx } = u;
    const { left, top, width, height } = u.bbox;
    ctx.save();
    ctx.beginPath();
    ctx.rect(left, top, width, height);
    ctx.clip();
    ctx.globalAlpha = 0.13;
    for (const span of this.figure?.spans ?? []) {
      const [a, b] = [u.valToPos(span.from, "x", true), u.valToPos(span.to, "x", true)];
      ctx.fillStyle = colourOf(span.id);
      ctx.fillRect(a, top, b - a, height);
    }
    ctx.restore();
  }

  /** Limits and marks. @param {uPlot} u @param {Panel} panel */
  #above(u, panel) {
    const { ctx } = u;
    const { left, top, width, height } = u.bbox;
    const { ink, soft, bad, paper } = look();
    const scale = uPlot.pxRatio;
    ctx.save();
    ctx.beginPath();
    ctx.rect(left, top, width, height);
    ctx.clip();
    ctx.font = `${11 * scale}px system-ui, sans-serif`;
    ctx.lineWidth = scale;
    const write = (/** @type {string} */ text, /** @type {number} */ x, /** @type {number} */ y, /** @type {string} */ colour) => {
      ctx.lineWidth = 3 * scale;
      ctx.strokeStyle = paper;
      ctx.strokeText(text, x, y);
      ctx.fillStyle = colour;
      ctx.fillText(text, x, y);
      ctx.lineWidth = scale;
    };
    for (const limit of panel.limits) {
      const y = u.valToPos(limit.y, "y", true);
      ctx.setLineDash([6 * scale, 4 * scale]);
      ctx.strokeStyle = ink;
      ctx.beginPath();
      ctx.moveTo(left, y);
      ctx.lineTo(left + width, y);
      ctx.stroke();
      ctx.setLineDash([]);
      ctx.textAlign = "right";
      write(limit.label, left + width - 4 * scale, y < top + 14 * scale ? y + 13 * scale : y - 4 * scale, soft);
    }
    ctx.textAlign = "left";
    let labelled = -Infinity;
    for (const mark of this.figure?.marks ?? []) {
      const x = u.valToPos(mark.t_s, "x", true);
      ctx.setLineDash([2 * scale, 3 * scale]);
      ctx.strokeStyle = mark.bad ? bad : soft;
      ctx.beginPath();
      ctx.moveTo(x, top);
      ctx.lineTo(x, top + height);
      ctx.stroke();
      ctx.setLineDash([]);
      if (x - labelled < 34 * scale) continue;
      labelled = x;
      write(mark.label, x + 3 * scale, top + 12 * scale, mark.bad ? bad : mark.id !== undefined ? colourOf(mark.id) : soft);
    }
    ctx.restore();
  }

  /** The values under the pointer. @param {uPlot} u @param {Panel} panel @param {HTMLElement} tip */
  #tell(u, panel, tip) {
    const { left, idx } = u.cursor;
    const here = u.over.matches(":hover");
    if (here) this.time.point(left === undefined || left < 0 ? null : u.posToVal(left, "x"));
    if (left === undefined || left < 0 || idx === null || idx === undefined || !here) return void (tip.hidden = true);
    const t_s = u.posToVal(left, "x");
    const rows = [];
    for (let k = 1; k < u.series.length; k += 1) {
      if (u.series[k].stroke === "transparent") continue;
      const values = u.data[k];
      let at = idx;
      while (at > 0 && values[at] === undefined) at -= 1;
      const value = values[at];
      if (value === null || value === undefined) continue;
      const swatch = h("i", { class: "swatch" });
      const stroke = u.series[k].stroke;
      swatch.style.background = String(typeof stroke === "function" ? stroke(u, k) : stroke);
      rows.push({ value, row: h("div", {}, swatch, `${u.series[k].label}: ${number(value, panel.digits)} ${panel.unit}`) });
    }
    const more = rows.length - MOST_VALUES;
    tip.replaceChildren(h("b", {}, `${t_s.toFixed(1)} s`), ...rows.slice(0, MOST_VALUES).map((one) => one.row), more > 0 ? `and ${more} more` : "");
    for (const mark of this.figure?.marks ?? []) {
      if (Math.abs(u.valToPos(mark.t_s, "x") - left) < 5) tip.append(h("div", {}, mark.text ?? `${mark.id === undefined ? mark.label : `${this.label(mark.id)} is next`}, ${mark.t_s.toFixed(1)} s`));
    }
    tip.hidden = false;
    const flip = left > u.over.clientWidth / 2;
    tip.style.left = flip ? "" : `${left + 12}px`;
    tip.style.right = flip ? `${u.over.clientWidth - left + 12}px` : "";
  }

  showNow() {
    this.plots.forEach((plot, k) => {
      const x = plot.valToPos(this.time.now_s, "x");
      const inside = Number.isFinite(x) && x >= 0 && x <= plot.over.clientWidth;
      this.nows[k].hidden = !inside;
      if (inside) this.nows[k].style.transform = `translateX(${x}px)`;
    });
  }

  close() {
    for (const plot of this.plots) plot.destroy();
    this.plots = [];
    this.nows = [];
  }
}

const STAGES = ["on the way", "in formation", "transfer"];

/**
 * Services as bars over time, a row for each receiver.
 * @param {HTMLElement} div @param {{rows: string[], bars: {row: string, stage: number, from: number, to: number, text: string}[]}} figure
 * @param {Time} time
 */
export function drawTimeline(div, figure, time) {
  const [begin_s, end_s] = [time.begin_s, Math.max(time.end_s, time.begin_s + 1e-3)];
  const share = (/** @type {number} */ t_s) => `${((100 * (t_s - begin_s)) / (end_s - begin_s)).toFixed(2)}%`;
  const rows = figure.rows.map((name) => {
    const track = h("div", { class: "track" });
    for (const bar of figure.bars.filter((one) => one.row === name)) {
      const told = `${STAGES[bar.stage]} ${bar.from.toFixed(1)} to ${bar.to.toFixed(1)} s, ${bar.text}`;
      const made = h("button", { type: "button", class: `bar stage${bar.stage}`, title: told, "aria-label": `${name}: ${told}`, onclick: () => time.seek(bar.from) });
      made.style.left = share(bar.from);
      made.style.width = `max(3px, ${share(begin_s + bar.to - bar.from)})`;
      track.append(made);
    }
    return h("div", { class: "row" }, h("span", { class: "row-name" }, name), track);
  });
  const key = h("p", { class: "small soft key" }, ...STAGES.map((name, k) => h("span", {}, h("i", { class: `swatch stage${k}` }), name)));
  const axis = h("div", { class: "row" }, h("span", { class: "row-name" }, "session time (s)"), h("div", { class: "ends" }, h("span", {}, begin_s.toFixed(0)), h("span", {}, end_s.toFixed(0))));
  div.replaceChildren(key, ...rows, axis);
  div.classList.add("bars");
  div.dataset.lines = String(figure.bars.length);
}

/**
 * Each vehicle's energy, where it came from and where it went.
 * @param {HTMLElement} div @param {{rows: Record<string, number>[]}} figure @param {Set<number>} chosen @param {(id: number) => string} label
 */
export function drawLedger(div, figure, chosen, label) {
  const kinds = [["initial", "initial_j", 0], ["received", "received_j", 0], ["drawn", "drawn_j", 1], ["given", "given_j", 1], ["remaining", "remaining_j", 1]];
  const rows = figure.rows.filter((row) => chosen.has(row.id));
  const most = Math.max(...rows.map((row) => row.initial_j + row.received_j), 1);
  const made = rows.flatMap((row) => [0, 1].map((side) => {
    const track = h("div", { class: "track stack" });
    kinds.forEach(([name, key, of], k) => {
      const value = row[String(key)];
      if (of !== side || !(value > 0)) return;
      const told = `${name} ${(value / 1e3).toFixed(1)} kJ`;
      const bar = h("span", { class: "bar", title: told, role: "img", "aria-label": told });
      bar.style.width = `${((100 * value) / most).toFixed(2)}%`;
      bar.style.background = sourceColour(k);
      track.append(bar);
    });
    return h("div", { class: "row" }, h("span", { class: "row-name" }, side ? "went" : `${label(row.id)}: came`), track);
  }));
  const swatches = kinds.map(([name], k) => {
    const swatch = h("i", { class: "swatch" });
    swatch.style.background = sourceColour(k);
    return h("span", {}, swatch, String(name));
  });
  const axis = h("div", { class: "row" }, h("span", { class: "row-name" }, "energy (kJ)"), h("div", { class: "ends" }, h("span", {}, "0"), h("span", {}, (most / 1e3).toFixed(0))));
  div.replaceChildren(h("p", { class: "small soft key" }, ...swatches), ...made, axis);
  div.classList.add("bars");
  div.dataset.lines = String(div.querySelectorAll(".bar").length);
}
