// The fleet from above, north up: obstacles, paths, vehicles with their headings, a scale. Drag, wheel or pinch move it.
// @ts-check
import { nearest } from "./box.js";
import { drawNorth } from "./compass.js";
import { fit, number } from "./elements.js";
import { last, unseen } from "./flight.js";
import { plane, sized } from "./graphics.js";
import { colourOf, dashOf, look } from "./look.js";
import { drawSign } from "./signs.js";
import { covered as covered_by_plans, drawPlans } from "./plans.js";

/** @typedef {import("./flight.js").Flight} Flight */
/** @typedef {import("./messages").SnapshotMessage} Snapshot */
/** @typedef {import("./messages").SessionLine} SessionLine */
/** @typedef {[number, number]} Plane */

const MARGIN = 0.08;
const MOST_NAMED = 40;
const TRAIL_POINTS = 50; // of each of more vehicles
const NICE = [1, 2, 5];

/** The nice length (1, 2 or 5 times a power of ten) next below a given one. @param {number} length */
export function nice(length) {
  const power = 10 ** Math.floor(Math.log10(length));
  return power * Math.max(...NICE.filter((one) => one * power <= length * 1.0001), 1);
}

/** @type {WeakMap<Flight, {version: number, session: unknown, found: [Plane, Plane, Plane] | null}>} */
const extents = new WeakMap();

/** What the flight covers: least and greatest north, east and height. @param {Flight} flight @returns {[Plane, Plane, Plane] | null} */
export function extent(flight) {
  const known = extents.get(flight);
  if (known && known.version === flight.version && known.session === flight.session) return known.found;
  const found = covered(flight);
  extents.set(flight, { version: flight.version, session: flight.session, found });
  return found;
}

/** @param {Flight} flight @returns {[Plane, Plane, Plane] | null} */
function covered(flight) {
  let [n0, n1, e0, e1, high] = [Infinity, -Infinity, Infinity, -Infinity, 0];
  /** @param {number} n @param {number} e @param {number} [d] */
  const add = (n, e, d = 0) => {
    if (Number.isNaN(n)) return;
    high = Math.max(high, -d);
    n0 = Math.min(n0, n);
    n1 = Math.max(n1, n);
    e0 = Math.min(e0, e);
    e1 = Math.max(e1, e);
  };
  for (const one of [flight, ...flight.ghosts]) {
    const step = Math.max(Math.floor(one.count / 100), 1);
    for (const columns of one.columns.values()) {
      for (let k = 0; k < one.count; k += step) add(columns.n[k], columns.e[k], columns.d[k]);
      if (one.count) add(columns.n[one.count - 1], columns.e[one.count - 1], columns.d[one.count - 1]);
    }
  }
  const sessions = flight.worlds.length ? flight.worlds.map((one) => one.session) : [flight.session];
  for (const one of sessions.flatMap((session) => session?.obstacles ?? [])) {
    add(one.centre_ned[0], one.centre_ned[1]);
    for (const [n, e] of one.outline_ne) add(n, e);
  }
  for (const one of flight.session?.bases ?? []) add(one.p_ned[0], one.p_ned[1]);
  for (const one of sessions.flatMap((session) => session?.vehicles ?? [])) for (const [n, e] of one.path_ned) add(n, e);
  for (const [n, e] of covered_by_plans(flight.session)) add(n, e);
  if (n0 > n1) return null;
  return [[n0, n1], [e0, e1], [0, high]];
}

export class MapView {
  /** @param {HTMLCanvasElement} canvas @param {(sysid: number | null, event: MouseEvent) => void} choose @param {boolean} still drawn once, for paper */
  constructor(canvas, choose, still = false) {
    this.canvas = canvas;
    this.still = still;
    /** @type {{n: number, e: number, m: number} | null} centre, and metres across the smaller side; null: everything */
    this.view = null;
    this.follow = false;
    /** @type {{sysid: number, x: number, y: number}[]} */
    this.places = [];
    this.dirty = true;
    /** @type {import("./tiles.js").Tiles | null} */
    this.tiles = null;
    /** @type {Map<number, {x: number, y: number}>} */
    const held = new Map();
    let travelled = 0;
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      held.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
      travelled = 0;
    });
    canvas.addEventListener("pointermove", (event) => {
      const before = held.get(event.pointerId);
      if (!before) return;
      const now = { x: event.offsetX, y: event.offsetY };
      const other = [...held].find(([id]) => id !== event.pointerId)?.[1];
      if (other) {
        const apart = (/** @type {{x: number, y: number}} */ a) => Math.hypot(a.x - other.x, a.y - other.y);
        this.zoom(apart(before) / Math.max(apart(now), 1), (now.x + other.x) / 2, (now.y + other.y) / 2);
      } else {
        this.pan(now.x - before.x, now.y - before.y);
      }
      travelled += Math.hypot(now.x - before.x, now.y - before.y);
      held.set(event.pointerId, now);
    });
    const release = (/** @type {PointerEvent} */ event) => {
      held.delete(event.pointerId);
      if (event.type !== "pointerup" || travelled > 4) return;
      choose(nearest(this.places, event.offsetX, event.offsetY), event);
    };
    canvas.addEventListener("pointerup", release);
    canvas.addEventListener("pointercancel", release);
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.zoom(Math.exp(event.deltaY * 0.0015), event.offsetX, event.offsetY);
    }, { passive: false });
    canvas.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: [40, 0], ArrowRight: [-40, 0], ArrowUp: [0, 40], ArrowDown: [0, -40] }[event.key];
      if (step) this.pan(step[0], step[1]);
      else if (event.key === "+" || event.key === "-") this.zoom(event.key === "+" ? 0.8 : 1.25);
      else if (event.key === "0") this.whole();
      else return;
      event.preventDefault();
      event.stopPropagation();
    });
  }

  whole() {
    this.view = null;
    this.follow = false;
    this.dirty = true;
  }

  /** @param {number} x @param {number} y */
  pan(x, y) {
    if (!this.frame) return;
    this.view ??= { n: this.frame.n, e: this.frame.e, m: this.frame.m };
    this.follow = false;
    this.view.e -= x / this.frame.perMetre;
    this.view.n += y / this.frame.perMetre;
    this.dirty = true;
  }

  /** @param {number} by @param {number} [x] @param {number} [y] */
  zoom(by, x, y) {
    const frame = this.frame;
    if (!frame) return;
    this.view ??= { n: frame.n, e: frame.e, m: frame.m };
    const m = Math.min(Math.max(this.view.m * by, 1), 1e6);
    const share = 1 - m / this.view.m;
    if (x !== undefined && y !== undefined) {
      this.view.e += (share * (x - frame.width / 2)) / frame.perMetre;
      this.view.n -= (share * (y - frame.height / 2)) / frame.perMetre;
    }
    this.view.m = m;
    this.dirty = true;
  }

  /**
   * @param {Flight} flight @param {Snapshot} snapshot
   * @param {{chosen: number | null, selected: Set<number>, paths: boolean, until_s: number, trail_s: number, shown?: Set<number> | null, ghosts?: Flight[]}} options
   *   `trail_s`: how much of their paths is drawn where there are many; `ghosts`: other flights, at the same time of theirs
   */
  draw(flight, snapshot, { chosen, selected, paths, until_s, trail_s, shown = null, ghosts = [] }) {
    const { width, height, scale } = fit(this.canvas);
    const context = plane(this.canvas);
    const colours = look();
    context.setTransform(scale, 0, 0, scale, 0, 0);
    context.fillStyle = colours.paper;
    context.fillRect(0, 0, width, height);
    const all = extent(flight);
    if (!all) return;
    const followed = this.follow && chosen !== null ? snapshot.vehicles.find((row) => row.sysid === chosen)?.p_ned : null;
    const [[n0, n1], [e0, e1]] = all;
    const fitted = Math.max((n1 - n0) / height, (e1 - e0) / width, 2 / Math.min(width, height)) * (1 + 2 * MARGIN);
    const whole = { n: (n0 + n1) / 2, e: (e0 + e1) / 2, m: fitted * Math.min(width, height) };
    const at = this.view ?? whole;
    if (followed) {
      this.view = { n: followed[0], e: followed[1], m: Math.min(at.m, Math.max(whole.m / 3, 12)) };
      if (this.view.m < at.m && at !== whole) this.view.m = at.m;
    }
    const { n, e, m } = this.view ?? whole;
    const perMetre = Math.min(width, height) / m;
    this.frame = { n, e, m, perMetre, width, height };
    const X = (/** @type {number} */ east) => width / 2 + (east - e) * perMetre;
    const Y = (/** @type {number} */ north) => height / 2 - (north - n) * perMetre;
    const origin = flight.session?.origin;
    if (this.tiles && origin) this.tiles.draw(context, origin, this.frame, X, Y, colours);
    this.#grid(context, X, Y, perMetre, width, height);
    this.#ground(context, flight.sessionAt(snapshot.t_s), X, Y, perMetre);
    drawPlans(context, flight.session, snapshot, X, Y);
    if (paths) this.#paths(context, flight, X, Y, until_s, trail_s, chosen, shown);
    this.#services(context, flight, snapshot, X, Y);
    for (const ghost of ghosts) this.#ghost(context, ghost, X, Y, until_s, paths);
    this.#vehicles(context, flight, snapshot, X, Y, perMetre, chosen, selected);
    this.#scale(context, perMetre, width, height);
    this.#wind(context, flight, width);
  }

  /** Where the wind blows, under the north arrow. @param {CanvasRenderingContext2D} context @param {Flight} flight @param {number} width */
  #wind(context, flight, width) {
    const wind = flight.session?.wind;
    if (!wind) return;
    const { ink } = look();
    const [x, y] = [width - 20, 64];
    context.save();
    context.translate(x, y);
    context.rotate(((wind.from_deg + 180) * Math.PI) / 180);
    context.strokeStyle = ink;
    context.lineWidth = 2;
    context.beginPath();
    [[0, 14], [0, -14]].forEach(([u, w], k) => context[k ? "lineTo" : "moveTo"](u, w));
    [[-5, -7], [0, -14], [5, -7]].forEach(([u, w], k) => context[k ? "lineTo" : "moveTo"](u, w));
    context.stroke();
    context.restore();
  }

  /** @typedef {(metres: number) => number} Axis */

  /** @param {CanvasRenderingContext2D} context @param {Axis} X @param {Axis} Y @param {number} perMetre @param {number} width @param {number} height */
  #grid(context, X, Y, perMetre, width, height) {
    const frame = /** @type {NonNullable<MapView["frame"]>} */ (this.frame);
    const step = nice(110 / perMetre) || 1;
    const { grid, soft } = look();
    context.lineWidth = 1;
    context.strokeStyle = grid;
    context.fillStyle = soft;
    context.font = "11px system-ui, sans-serif";
    const digits = step < 1 ? 1 : 0;
    const west = Math.ceil((frame.e - width / 2 / perMetre) / step) * step;
    context.beginPath();
    for (let e = west; X(e) < width; e += step) {
      context.moveTo(X(e), 0);
      context.lineTo(X(e), height);
    }
    const south = Math.ceil((frame.n - height / 2 / perMetre) / step) * step;
    for (let n = south; Y(n) > 0; n += step) {
      context.moveTo(0, Y(n));
      context.lineTo(width, Y(n));
    }
    context.stroke();
    context.textAlign = "center";
    for (let e = west; X(e) < width - 30; e += step) if (X(e) > 40) context.fillText(`E ${number(e, digits)}`, X(e), height - 5);
    context.textAlign = "left";
    for (let n = south; Y(n) > 24; n += step) if (Y(n) < height - 24) context.fillText(`N ${number(n, digits)}`, 5, Y(n) - 3);
  }

  /** @param {CanvasRenderingContext2D} context @param {SessionLine | null} session @param {Axis} X @param {Axis} Y @param {number} perMetre */
  #ground(context, session, X, Y, perMetre) {
    const { solid, soft, crowd } = look();
    context.strokeStyle = solid;
    context.fillStyle = crowd;
    context.lineWidth = 1.2;
    for (const one of session?.obstacles ?? []) {
      context.beginPath();
      if (one.outline_ne.length) {
        one.outline_ne.forEach(([north, east], k) => context[k ? "lineTo" : "moveTo"](X(east), Y(north)));
        context.fill();
        context.stroke();
      } else {
        const [x, y] = [X(one.centre_ned[1]), Y(one.centre_ned[0])];
        context.moveTo(x - 5, y - 5);
        context.lineTo(x + 5, y + 5);
        context.moveTo(x + 5, y - 5);
        context.lineTo(x - 5, y + 5);
        context.stroke();
      }
    }
    context.setLineDash([6, 5]);
    context.strokeStyle = soft;
    for (const member of session?.vehicles ?? []) {
      context.beginPath();
      member.path_ned.forEach(([north, east], k) => context[k ? "lineTo" : "moveTo"](X(east), Y(north)));
      context.stroke();
    }
    context.setLineDash([]);
    context.font = "12px system-ui, sans-serif";
    context.fillStyle = soft;
    for (const base of session?.bases ?? []) {
      const [x, y] = [X(base.p_ned[1]), Y(base.p_ned[0])];
      context.strokeStyle = soft;
      context.lineWidth = 2;
      context.strokeRect(x - 6, y - 6, 12, 12);
      context.fillText(`base ${base.name}`, x + 9, y + 4);
    }
    void perMetre;
  }

  /**
   * @param {CanvasRenderingContext2D} context @param {Flight} flight @param {Axis} X @param {Axis} Y
   * @param {number} until_s @param {number} trail_s @param {number | null} chosen @param {Set<number> | null} shown
   */
  #paths(context, flight, X, Y, until_s, trail_s, chosen, shown) {
    const many = flight.columns.size > MOST_NAMED;
    const count = last(flight.t_s, until_s + 1e-6, flight.count) + 1;
    const recent = last(flight.t_s, until_s - trail_s, flight.count) + 1;
    const { soft } = look();
    context.lineJoin = "round";
    const starts = many ? 0 : 3;
    for (const [sysid, columns] of flight.columns) {
      if (shown && !shown.has(sysid) && !many) continue;
      const lit = sysid === chosen || (shown?.has(sysid) ?? false);
      context.globalAlpha = lit || !many ? (chosen === null || lit ? 0.95 : 0.45) : 0.35;
      context.strokeStyle = colourOf(sysid);
      context.lineWidth = lit ? 2.4 : 1.4;
      context.setLineDash(many ? [] : dashOf(sysid));
      const from = lit || !many ? 0 : recent;
      this.#line(context, columns.e, columns.n, (k) => unseen(columns, k), from, count, Math.max(Math.floor((count - from) / (lit || !many ? 2000 : TRAIL_POINTS)), 1), X, Y);
      const k = columns.n.findIndex((value) => !Number.isNaN(value));
      if (!starts || k < 0 || k >= count) continue;
      context.setLineDash([]);
      context.beginPath();
      context.arc(X(columns.e[k]), Y(columns.n[k]), starts, 0, 2 * Math.PI); // where it began
      context.stroke();
    }
    context.globalAlpha = 0.9;
    context.strokeStyle = soft;
    context.setLineDash([2, 4]);
    for (const [n, e] of flight.traffic.values()) this.#line(context, e, n, (k) => Number.isNaN(n[k]), 0, count, Math.max(Math.floor(count / 500), 1), X, Y);
    context.setLineDash([]);
    context.globalAlpha = 1;
  }

  /** @param {CanvasRenderingContext2D} context @param {Float32Array} e @param {Float32Array} n @param {(k: number) => boolean} gap @param {number} from @param {number} count @param {number} step @param {Axis} X @param {Axis} Y */
  #line(context, e, n, gap, from, count, step, X, Y) {
    context.beginPath();
    let drawn = false;
    for (let k = from; k < count; k = k + step < count || k === count - 1 ? k + step : count - 1) {
      if (gap(k)) {
        drawn = false;
        continue;
      }
      context[drawn ? "lineTo" : "moveTo"](X(e[k]), Y(n[k]));
      drawn = true;
    }
    context.stroke();
  }

  /** @param {CanvasRenderingContext2D} context @param {Flight} flight @param {Snapshot} snapshot @param {Axis} X @param {Axis} Y */
  #services(context, flight, snapshot, X, Y) {
    const at = new Map(snapshot.vehicles.map((row) => [row.sysid, row.p_ned]));
    const bases = new Map((flight.session?.bases ?? []).map((base) => [base.name, base.p_ned]));
    const { warn } = look();
    for (const service of snapshot.services) {
      const giver = service.tanker !== null ? at.get(service.tanker) : bases.get(service.base ?? "");
      const receiver = at.get(service.receiver);
      if (!giver || !receiver) continue;
      context.strokeStyle = warn;
      context.lineWidth = service.phase === "transfer" ? 4 : 1.5;
      context.setLineDash(service.phase === "transfer" ? [] : [4, 4]);
      context.beginPath();
      context.moveTo(X(giver[1]), Y(giver[0]));
      context.lineTo(X(receiver[1]), Y(receiver[0]));
      context.stroke();
    }
    context.setLineDash([]);
  }

  /** @param {CanvasRenderingContext2D} context @param {Flight} flight @param {Snapshot} snapshot @param {Axis} X @param {Axis} Y @param {number} perMetre @param {number | null} chosen @param {Set<number>} selected */
  #vehicles(context, flight, snapshot, X, Y, perMetre, chosen, selected) {
    const colours = look();
    const ring_m = flight.session?.ring_m ?? null;
    const many = snapshot.vehicles.length > MOST_NAMED;
    const size = sized(many ? 5 : 8);
    this.places = [];
    for (const row of snapshot.vehicles) {
      if (!row.p_ned) continue;
      const [x, y] = [X(row.p_ned[1]), Y(row.p_ned[0])];
      this.places.push({ sysid: row.sysid, x, y });
      if (row.role === "target" && ring_m !== null) {
        context.strokeStyle = colours.soft;
        context.lineWidth = 1;
        context.setLineDash([3, 4]);
        context.beginPath();
        context.arc(x, y, ring_m * perMetre, 0, 2 * Math.PI);
        context.stroke();
        context.setLineDash([]);
      }
      context.fillStyle = colourOf(row.sysid);
      context.strokeStyle = colours.paper;
      context.lineWidth = 1.5;
      context.save();
      context.translate(x, y);
      context.rotate(row.heading_rad ?? 0);
      context.beginPath();
      if (row.role === "tanker") context.rect(-size, -size, 2 * size, 2 * size);
      else if (row.role === "target") [[0, -1.3], [1.1, 0], [0, 1.3], [-1.1, 0]].forEach(([u, w], k) => context[k ? "lineTo" : "moveTo"](u * size, w * size));
      else [[0, -1.5], [1, 1.1], [0, 0.6], [-1, 1.1]].forEach(([u, w], k) => context[k ? "lineTo" : "moveTo"](u * size, w * size));
      context.closePath();
      context.fill();
      context.stroke();
      context.restore();
      drawSign(context, row, x, y, size);
      if (selected.has(row.sysid)) {
        context.strokeStyle = colours.ink;
        context.lineWidth = row.sysid === chosen ? 2.5 : 1.5;
        context.beginPath();
        context.arc(x, y, size + 8, 0, 2 * Math.PI);
        context.stroke();
      }
    }
    for (const craft of snapshot.traffic) {
      const [x, y] = [X(craft.p_ned[1]), Y(craft.p_ned[0])];
      context.strokeStyle = colours.warn;
      context.lineWidth = 2;
      context.beginPath();
      [[0, -8], [8, 6], [-8, 6], [0, -8]].forEach(([u, w], k) => context[k ? "lineTo" : "moveTo"](x + u, y + w));
      context.stroke();
      this.#name(context, craft.callsign, x, y, colours.warn, []);
    }
    /** @type {[number, number, number, number][]} */
    const taken = this.places.map((one) => [one.x - size, one.y - size, one.x + size, one.y + size]);
    const named = snapshot.vehicles.filter((row) => !many || row.sysid === chosen || row.severity > 1 || row.role !== "pursuer");
    named.sort((a, b) => Number(b.sysid === chosen) - Number(a.sysid === chosen) || b.severity - a.severity);
    context.font = `600 ${sized(12)}px system-ui, sans-serif`;
    context.lineJoin = "round";
    for (const row of named.slice(0, MOST_NAMED)) {
      if (row.p_ned) this.#name(context, String(row.sysid), X(row.p_ned[1]), Y(row.p_ned[0]), colours.ink, taken);
    }
  }

  /** Another flight: hollow, in grey. @param {CanvasRenderingContext2D} context @param {Flight} ghost @param {Axis} X @param {Axis} Y @param {number} until_s @param {boolean} paths */
  #ghost(context, ghost, X, Y, until_s, paths) {
    const { soft, paper } = look();
    const count = last(ghost.t_s, until_s + 1e-6, ghost.count) + 1;
    context.strokeStyle = soft;
    context.lineWidth = 1.2;
    context.setLineDash([5, 3]);
    if (paths) for (const columns of ghost.columns.values()) this.#line(context, columns.e, columns.n, (k) => unseen(columns, k), 0, count, Math.max(Math.floor(count / 500), 1), X, Y);
    context.setLineDash([]);
    context.font = "11px system-ui, sans-serif";
    for (const row of ghost.at(until_s)?.vehicles ?? []) {
      if (!row.p_ned) continue;
      const [x, y] = [X(row.p_ned[1]), Y(row.p_ned[0])];
      context.beginPath();
      context.arc(x, y, 6, 0, 2 * Math.PI);
      context.fillStyle = paper;
      context.fill();
      context.stroke();
      this.#name(context, `(${row.sysid})`, x, y, soft, []);
    }
  }

  /** A name beside a place, where nothing stands yet. @param {CanvasRenderingContext2D} context @param {string} text @param {number} x @param {number} y @param {string} colour @param {[number, number, number, number][]} taken */
  #name(context, text, x, y, colour, taken) {
    const width = context.measureText(text).width;
    for (const [u, w] of [[11, -6], [-11 - width, -6], [-width / 2, -14], [-width / 2, 22], [11, 14], [-11 - width, 14]]) {
      const box = /** @type {[number, number, number, number]} */ ([x + u, y + w - 10, x + u + width, y + w + 3]);
      if (taken.some((other) => box[0] < other[2] && box[2] > other[0] && box[1] < other[3] && box[3] > other[1])) continue;
      taken.push(box);
      context.lineWidth = 3;
      context.strokeStyle = look().paper;
      context.strokeText(text, x + u, y + w);
      context.fillStyle = colour;
      context.fillText(text, x + u, y + w);
      return;
    }
  }

  /** @param {CanvasRenderingContext2D} context @param {number} perMetre @param {number} width @param {number} height */
  #scale(context, perMetre, width, height) {
    const { ink, paper } = look();
    const length = nice(Math.min(160, 0.4 * width) / perMetre);
    const [right, y] = [width - 14, height - 24];
    const left = right - length * perMetre;
    for (const [colour, wide] of /** @type {[string, number][]} */ ([[paper, 6], [ink, 2]])) {
      context.strokeStyle = colour;
      context.lineWidth = wide;
      context.beginPath();
      context.moveTo(left, y - 5);
      context.lineTo(left, y);
      context.lineTo(right, y);
      context.lineTo(right, y - 5);
      context.stroke();
    }
    context.fillStyle = ink;
    context.textAlign = "right";
    context.font = "12px system-ui, sans-serif";
    context.fillText(`${length} m`, right, y - 9);
    drawNorth(context, width - 20, 20, 0);
    context.textAlign = "left";
  }
}
