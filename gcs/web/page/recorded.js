// A recorded flight that the page carries: nothing is loaded. The page plays it, and draws the report's figures.
// @ts-check
import { App, SPEEDS } from "./app.js";
import { drawLedger, drawTimeline, TimeChart } from "./charts.js";
import { h } from "./elements.js";
import { CHANNELS, Flight, last, Words } from "./flight.js";
import { colourOf, nextTheme, onLook, setMembers, setPrinting } from "./look.js";
import { MapView } from "./map.js";
import { linkedTime } from "./timeline.js";

/** @typedef {{at: number, n: number, low: number, high: number}} Packed */
/** @typedef {{id?: number, label?: string} & Packed} PackedLine */
/** @typedef {import("./charts.js").Figure & {kind: "time"}} TimeFigure */
/**
 * @typedef {{count: number, end_s: number, session: import("./messages").SessionLine,
 *   vehicles: {sysid: number, p: Packed[], age: Packed, heading?: Packed, roll?: Packed, pitch?: Packed}[],
 *   traffic: {callsign: string, p: Packed[]}[], targets: Record<string, [number, number][]>, words: Record<string, [number, string, boolean, boolean][]>,
 *   health: {rows: Partial<import("./messages").VehicleRow>[], of: Record<string, [number, number][]>},
 *   events: import("./messages").EventRow[], history: import("./messages").ServedRow[], threshold: number,
 *   goal: import("./messages").GoalStateRow, solids?: import("./messages").ObstacleRow[],
 *   worlds?: [number, number[], Record<string, [number, number, number][]>][]}} Recording
 * @typedef {{end_s: number, many: boolean, vehicles: {id: number, role: string, label: string, colour: number}[], chosen: number[],
 *   figures: Record<string, any>, flight: Recording | null}} Model
 */

const PRINTED = { whole: 680, half: 332 }; // A4 within its margins, in CSS pixels
const PLAYED_MS = 30;

/** @param {Document} page @param {string} id @returns {Promise<ArrayBuffer>} */
async function unpack(page, id) {
  const text = atob((page.getElementById(id)?.textContent ?? "").trim());
  const bytes = Uint8Array.from(text, (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}

/** When each stage was reached, in ms since the page was asked for: tests and `make bench` read it. @param {string} stage */
function mark(stage) {
  document.documentElement.dataset[stage] = String(Math.round(performance.now()));
}

/** @param {ArrayBuffer} series @param {number} at @param {number} n @param {number} low @param {number} high */
function scaled(series, at, n, low, high) {
  const raw = new Uint16Array(series, at, n);
  const values = new Float64Array(n);
  const unit = (high - low) / 65534;
  for (let i = 0; i < n; i += 1) values[i] = raw[i] === 65535 ? NaN : low + unit * raw[i];
  return values;
}

/** Give a model's lines their values; what does so for a column. @param {Model} model @param {ArrayBuffer} series */
function scaling(model, series) {
  const line = (/** @type {any} */ r) => ({ ...r, x: scaled(series, r.at, r.n, 0, model.end_s), y: scaled(series, r.at + 2 * r.n, r.n, r.low, r.high) });
  for (const figure of Object.values(model.figures)) {
    for (const panel of figure.panels ?? []) {
      panel.lines = panel.lines.map(line);
      panel.own = panel.own.map(line);
      if (panel.band) for (const name of ["least", "median", "greatest"]) panel.band[name] = line(panel.band[name]);
    }
  }
  return (/** @type {Packed} */ r) => Float32Array.from(scaled(series, r.at, r.n, r.low, r.high));
}

/** The flight and the figures in another report, read as data: nothing of it runs. @param {File} file */
async function readReport(file) {
  const page = new DOMParser().parseFromString(await file.text(), "text/html");
  const text = page.getElementById("model")?.textContent;
  /** @type {Model | null} */
  const model = text ? JSON.parse(text) : null;
  if (!model?.flight) throw new Error("it carries no flight");
  const flight = new Flight();
  fillFlight(flight, model, model.flight, scaling(model, await unpack(page, "series")));
  return { flight, figures: model.figures };
}

/** What shows further reports' flights as ghosts in this one's picture and figures. @param {App} app @param {(figures: Model["figures"][]) => void} draw their figures */
function comparison(app, draw) {
  const told = h("span", { class: "small soft", role: "status" });
  const input = h("input", { type: "file", accept: ".html", multiple: true, "aria-label": "reports to compare with", onchange: async () => {
    const files = [...(input.files ?? [])];
    /** @type {Flight[]} */
    const ghosts = [];
    /** @type {Model["figures"][]} */
    const figures = [];
    const said = [];
    for (const file of files) {
      try {
        const other = await readReport(file);
        ghosts.push(other.flight);
        figures.push(other.figures);
        said.push(`${other.flight.session?.name ?? file.name}, ${other.flight.last_s.toFixed(1)} s`);
      } catch (problem) {
        said.push(`${file.name} is no report that can be compared (${/** @type {Error} */ (problem).message})`);
      }
    }
    told.textContent = said.length ? `In grey, ids in brackets: ${said.join("; ")}` : "";
    app.ghosts = ghosts;
    draw(figures);
  } });
  return h("label", { class: "small compare" }, "compare with other reports ", input, " ", told);
}

/** A line's values at given times, straight on between its points. @param {{x: Float64Array, y: Float64Array}} line @param {Float64Array} t_s */
function sampled({ x, y }, t_s) {
  return Float32Array.from(t_s, (at) => {
    const k = last(x, at);
    if (k < 0) return NaN;
    const m = Math.min(k + 1, x.length - 1);
    const span = x[m] - x[k];
    const between = y[k] + (span > 0 ? (at - x[k]) / span : 0) * (y[m] - y[k]);
    return Number.isNaN(between) ? y[k] : between;
  });
}

/**
 * @param {{palette: unknown}} config
 * @param {(app: App, orders: any[], ask: () => void) => HTMLDialogElement} keyboard
 */
export async function recorded(config, keyboard) {
  void config;
  /** @type {Model} */
  const model = JSON.parse(document.getElementById("model")?.textContent ?? "{}");
  const series = await unpack(document, "series");
  mark("unpacked");
  const column = scaling(model, series);
  setMembers(model.vehicles.map((one) => ({ sysid: one.id, role: one.role, colour: one.colour })));
  const chosen = new Set(model.chosen);
  const label = (/** @type {number} */ id) => model.vehicles.find((one) => one.id === id)?.label ?? String(id);

  const root = document.getElementById("app");
  const app = root && model.flight ? play(root, model, model.flight, column) : null;
  const time = app?.time ?? new TimeOnly(model.end_s);
  time.begin_s = 0;
  time.end_s = model.end_s;
  if (app) {
    app.shown = chosen;
    app.given = true;
    app.after.push(() => picked());
    const help = keyboard(app, [], () => {});
    const tools = h("div", { class: "tools only-screen" }, h("button", { type: "button", onclick: () => nextTheme() }, "dark / light"), h("button", { type: "button", onclick: () => help.showModal() }, "keys ?"), comparison(app, compared));
    app.strip.element.classList.add("only-screen");
    root?.before(h("div", { class: "over-flight" }, tools, app.strip.element));
  }

  // figures

  /** @type {{div: HTMLElement, draw: (width?: number) => void, drawn: boolean}[]} */
  const plots = [];
  for (const div of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll(".plot[data-figure]"))) {
    const figure = model.figures[div.dataset.figure ?? ""];
    if (!figure && div.dataset.figure !== "flight") continue;
    plots.push({ div, draw: drawing(div, figure), drawn: false });
  }

  /** @param {HTMLElement} div @param {any} figure @returns {(width?: number) => void} */
  function drawing(div, figure) {
    if (div.dataset.figure === "flight") return () => printed(div);
    if (figure.kind === "timeline") return () => drawTimeline(div, figure, time);
    if (figure.kind === "ledger") return () => drawLedger(div, figure, chosen, label);
    const chart = new TimeChart(div, time, label);
    return (width) => chart.draw(figure, chosen, width);
  }

  /** Draw the lines of other reports beneath those of the same figures here. @param {Model["figures"][]} others */
  function compared(others) {
    for (const [name, figure] of Object.entries(model.figures)) {
      figure.panels?.forEach((/** @type {import("./charts.js").Panel} */ panel, /** @type {number} */ k) => {
        panel.ghosts = others.flatMap((figures) => figures[name]?.panels?.[k]?.lines ?? []);
      });
    }
    redraw();
  }

  /** The map as a still, for paper. @param {HTMLElement} div */
  function printed(div) {
    if (!app) return;
    const canvas = h("canvas", { class: "still" });
    div.replaceChildren(canvas);
    const snapshot = app.flight.at(model.end_s);
    if (snapshot) new MapView(canvas, () => {}).draw(app.flight, snapshot, { chosen: null, selected: new Set(), paths: true, until_s: model.end_s, trail_s: Infinity, shown: chosen });
    div.dataset.lines = String(chosen.size);
  }

  const paper = (/** @type {HTMLElement} */ div) => div.classList.contains("only-print");
  /** @param {typeof plots[number]} plot @param {number} [width] */
  function draw(plot, width) {
    if (!plot.drawn) plot.div.replaceChildren();
    plot.draw(width);
    plot.drawn = true;
  }
  const redraw = () => plots.filter((one) => one.drawn && !paper(one.div)).forEach((one) => draw(one));

  // who is shown

  const picker = /** @type {HTMLElement} */ (document.querySelector("fieldset.picker"));
  function fill() {
    picker.querySelectorAll("button, select").forEach((old) => old.remove());
    const listed = model.many ? [...chosen].sort((a, b) => a - b) : model.vehicles.map((one) => one.id);
    for (const id of listed) {
      const swatch = h("i", { class: "swatch" });
      swatch.style.background = colourOf(id);
      picker.append(h("button", { type: "button", "aria-pressed": String(chosen.has(id)), onclick: () => change(id) }, swatch, label(id)));
    }
    if (!model.many) return;
    const rest = model.vehicles.filter((one) => !chosen.has(one.id)).map((one) => h("option", { value: one.id }, one.label));
    const select = h("select", { "aria-label": "show one more vehicle", onchange: () => select.value && change(Number(select.value)) }, h("option", { value: "" }, "show one more …"), ...rest);
    picker.append(select);
  }
  /** @param {number} id */
  function change(id) {
    if (!chosen.delete(id)) chosen.add(id);
    picked();
  }
  function picked() {
    fill();
    redraw();
    if (app) app.dirty = true;
  }
  fill();
  sortable();

  if (app) await app.first;
  mark("first");
  const near = plots.filter((one) => !paper(one.div));
  const waiting = new Set(near);
  for (const plot of near) {
    draw(plot);
    waiting.delete(plot);
    await new Promise((resolve) => { setTimeout(resolve); }); // the reader may scroll meanwhile
  }
  mark("flat");
  requestAnimationFrame(() => requestAnimationFrame(() => mark("all"))); // in the second frame, the first is on the screen

  onLook(() => {
    fill();
    redraw();
  });
  let width = document.body.clientWidth;
  let printing = false;
  window.addEventListener("resize", () => {
    if (printing || document.body.clientWidth === width) return;
    width = document.body.clientWidth;
    redraw();
  });
  window.addEventListener("beforeprint", () => {
    printing = true;
    setPrinting(true);
    for (const plot of plots) draw(plot, plot.div.closest(".pair") ? PRINTED.half : PRINTED.whole);
  });
  window.addEventListener("afterprint", () => {
    printing = false;
    setPrinting(false);
    redraw();
  });
  return app;
}

/** The time of figures where there is nothing to play. */
class TimeOnly {
  /** @param {number} end_s */
  constructor(end_s) {
    this.begin_s = 0;
    this.end_s = end_s;
    this.now_s = NaN;
    /** @type {[number, number] | null} */
    this.zoom = null;
    /** @type {Set<TimeChart>} */
    this.charts = new Set();
  }

  /** @returns {[number, number]} */
  get range() {
    return this.zoom ?? [0, this.end_s];
  }

  /** @param {[number, number] | null} zoom */
  setZoom(zoom) {
    this.zoom = zoom;
    const [min, max] = this.range;
    for (const chart of this.charts) for (const plot of chart.plots) plot.setScale("x", { min, max });
  }

  setNow() {}

  seek() {}

  point() {}
}

/** @param {HTMLElement} root @param {Model} model @param {Recording} told @param {(packed: Packed) => Float32Array} column */
function play(root, model, told, column) {
  const state = { playing: false, speed: 5, at: performance.now() };
  const player = {
    seek: (/** @type {number} */ t_s) => {
      app.at_s = Math.min(Math.max(t_s, 0), told.end_s);
      app.dirty = true;
    },
    toggle: () => {
      state.playing = !state.playing;
      if (state.playing && (app.at_s ?? told.end_s) >= told.end_s) app.at_s = 0;
      state.at = performance.now();
      shown();
    },
    faster: (/** @type {number} */ step) => {
      state.speed = SPEEDS[Math.min(Math.max(SPEEDS.indexOf(state.speed) + step, 0), SPEEDS.length - 1)];
      shown();
    },
    newest: null,
  };
  const app = new App(root, { charts: false, player });
  app.whole_paths = true;
  const shown = () => {
    app.playing = state.playing;
    app.speed = `×${state.speed}`;
    app.dirty = true;
  };
  fillFlight(app.flight, model, told, column);
  app.begin_s = 0;
  app.end_s = told.end_s;
  app.members();
  shown();
  const follow = () => player.seek(linkedTime() ?? told.end_s);
  follow();
  addEventListener("hashchange", () => linkedTime() !== null && follow());
  setInterval(() => {
    const now = performance.now();
    if (state.playing) {
      app.at_s = Math.min((app.at_s ?? 0) + (1e-3 * (now - state.at) * state.speed), told.end_s);
      if (app.at_s >= told.end_s) state.playing = false;
      shown();
    }
    state.at = now;
  }, PLAYED_MS);
  return app;
}

/** @param {Flight} flight @param {Model} model @param {Recording} told @param {(packed: Packed) => Float32Array} column */
function fillFlight(flight, model, told, column) {
  flight.session = told.session;
  const solids = told.solids ?? [];
  flight.worlds = (told.worlds ?? []).map(([t_s, there, paths]) => ({
    t_s,
    session: {
      ...told.session, obstacles: there.map((k) => solids[k]),
      vehicles: told.session.vehicles.map((one) => ({ ...one, path_ned: paths[String(one.sysid)] ?? one.path_ned })),
    },
  }));
  flight.events = told.events;
  flight.count = flight.capacity = told.count;
  flight.t_s = Float64Array.from({ length: told.count }, (_, k) => (k * told.end_s) / (told.count - 1));
  flight.share = new Float32Array(told.count).fill(NaN);
  /** @param {string} figure @param {number} panel @returns {Map<number, any>} */
  const lines = (figure, panel) => new Map((model.figures[figure]?.panels[panel]?.lines ?? []).map((/** @type {any} */ one) => [one.id, one]));
  // What a message said last holds until the next one; a speed is drawn as its place is, straight on.
  const sources = { battery: lines("battery", 0), v: lines("contest", 0), lost: lines("link", 1) };
  const speeds = lines("motion", 0);
  const share = model.figures.contest?.panels[1]?.own[0];
  if (share) flight.share = sampled(share, flight.t_s);
  for (const one of told.vehicles) {
    const columns = /** @type {any} */ ({});
    for (const name of CHANNELS) columns[name] = null;
    [columns.n, columns.e, columns.d] = one.p.map(column);
    columns.height = columns.d.map((/** @type {number} */ d) => -d);
    for (const name of /** @type {const} */ (["heading", "roll", "pitch"])) columns[name] = one[name] ? column(one[name]) : new Float32Array(told.count).fill(NaN);
    columns.age = column(one.age);
    for (const [name, from] of Object.entries(sources)) {
      const source = from.get(one.sysid);
      columns[name] = source ? held(source, flight.t_s) : null;
    }
    const speed = speeds.get(one.sysid);
    columns.speed = speed ? kept(sampled(speed, flight.t_s)) : null;
    const none = new Float32Array(told.count).fill(NaN);
    for (const name of CHANNELS) columns[name] ??= none;
    flight.columns.set(one.sysid, columns);
    flight.words.set(one.sysid, wordsOf(told, String(one.sysid)));
  }
  for (const [sysid, spans] of Object.entries(told.targets)) toTarget(flight, Number(sysid), spans);
  for (const one of told.traffic) flight.traffic.set(one.callsign, one.p.map(column));
  flight.newest = /** @type {import("./messages").SnapshotMessage} */ ({
    type: "snapshot", t_s: told.end_s, duration_s: told.session.duration_s, speed: null, phase: "ended", vehicles: [], traffic: [],
    competition: { v: {}, tau: {}, leader: null, share: null, runner_up: null, threshold: told.threshold }, services: [], history: told.history,
    refuelled: told.history.length, goal: told.goal, inspected: {}, events: [],
  });
  flight.version += 1;
}

/** Distances of a pursuer to its target, by where both are shown. @param {Flight} flight @param {number} sysid @param {[number, number][]} spans time and target, where it changes */
function toTarget(flight, sysid, spans) {
  const own = flight.columns.get(sysid);
  if (!own) return;
  const times = spans.map(([t_s]) => t_s);
  own.target = Float32Array.from(flight.t_s.subarray(0, flight.count), (t_s, k) => {
    const target = flight.columns.get(spans[Math.max(last(times, t_s), 0)][1]);
    return target ? Math.hypot(target.n[k] - own.n[k], target.e[k] - own.e[k], target.d[k] - own.d[k]) : NaN;
  });
}

/** A vehicle's words: modes and troubles, each from when it changed. @param {Recording} told @param {string} sysid */
function wordsOf(told, sysid) {
  const [modes, troubles] = [told.words[sysid] ?? [], told.health?.of[sysid] ?? []];
  const words = new Words();
  words.t_s = [...new Set([...modes, ...troubles].map(([t_s]) => t_s))].sort((a, b) => a - b);
  let [m, k] = [0, 0];
  words.rows = words.t_s.map((t_s) => {
    while (m + 1 < modes.length && modes[m + 1][0] <= t_s) m += 1;
    while (k + 1 < troubles.length && troubles[k + 1][0] <= t_s) k += 1;
    const [, mode_name = "", armed = true, in_air = true] = modes[m] ?? [];
    const trouble = troubles[k] ? told.health.rows[troubles[k][1]] : {};
    return { mode_name, armed, landed: !in_air, alive: trouble.condition !== "dead", ...trouble };
  });
  return words;
}

/** A line's values at given times, each until the next point. @param {{x: Float64Array, y: Float64Array}} line @param {Float64Array} t_s */
function held({ x, y }, t_s) {
  return Float32Array.from(t_s, (at) => y[last(x, at)] ?? NaN);
}

/** A column whose unknown values are the last known ones. @param {Float32Array} column */
function kept(column) {
  for (let k = 1; k < column.length; k += 1) if (Number.isNaN(column[k])) column[k] = column[k - 1];
  return column;
}

/** Let a reader sort the tables that say so. */
function sortable() {
  for (const table of /** @type {NodeListOf<HTMLTableElement>} */ (document.querySelectorAll("table.sorts"))) {
    const heads = [...(table.tHead?.rows[0].cells ?? [])];
    heads.forEach((head, k) => {
      const sort = () => {
        const up = head.getAttribute("aria-sort") !== "ascending";
        heads.forEach((other) => other.removeAttribute("aria-sort"));
        head.setAttribute("aria-sort", up ? "ascending" : "descending");
        const key = (/** @type {HTMLTableRowElement} */ row) => row.cells[k].textContent ?? "";
        const rows = [...table.tBodies[0].rows].sort((a, b) => key(a).localeCompare(key(b), undefined, { numeric: true }));
        table.tBodies[0].append(...(up ? rows : rows.reverse()));
      };
      head.replaceChildren(h("button", { type: "button", onclick: sort }, head.textContent ?? ""));
    });
  }
}
