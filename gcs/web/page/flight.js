// What has been seen of a flight, as columns over time; a snapshot of any past time is put together from them.
// @ts-check

/** @typedef {import("./messages").SnapshotMessage} Snapshot */
/** @typedef {import("./messages").VehicleRow} VehicleRow */
/** @typedef {import("./messages").SessionLine} SessionLine */
/** @typedef {import("./messages").EventRow} EventRow */
/** @typedef {import("./messages").ServiceRow} ServiceRow */
/** @typedef {import("./messages").ServedRow} ServedRow */

export const CHANNELS = /** @type {const} */ ([
  "n", "e", "d", "heading", "roll", "pitch", "speed", "height", "battery", "power", "target", "v", "lost", "age",
]);
/** @typedef {typeof CHANNELS[number]} Channel */
const TURNS = new Set(["heading", "roll", "pitch"]);
const GAP_S = 2; // silence longer than this is a gap in a path, as in the report's figures
const MOST_SAMPLES = 4000;
const MOST_NUMBERS = 6e6; // of all columns together: 24 MB
const FIRST_SPACING_S = 0.09;
const MOST_EVENTS = 6000;
const MOST_WORLDS = 600;

/** The numbers of one vehicle at one time, in the channels' order. @param {VehicleRow} row */
function numbersOf(row) {
  const [n, e, d] = row.p_ned ?? [NaN, NaN, NaN];
  const battery = row.battery === null ? NaN : 100 * row.battery;
  return [n, e, d, row.heading_rad ?? NaN, row.roll_rad ?? NaN, row.pitch_rad ?? NaN, row.speed_m_s ?? NaN, row.height_m ?? NaN, battery,
    row.power_w ?? NaN, row.target_m ?? NaN, row.v ?? NaN, row.lost, row.age_s ?? NaN];
}

/** Everything of a vehicle that is no number over time; kept where it changes. */
export class Words {
  constructor() {
    /** @type {number[]} */
    this.t_s = [];
    /** @type {Partial<VehicleRow>[]} */
    this.rows = [];
    this.last = "";
  }

  /** @param {number} t_s @param {VehicleRow} row */
  take(t_s, row) {
    const { mode, mode_name, stage, state, alive, armed, landed, note, trouble, severity, condition, figure, urgency, autopilot } = row;
    const words = { mode, mode_name, stage, state, alive, armed, landed, note, trouble, severity, condition, figure, urgency, autopilot };
    const key = JSON.stringify(words);
    if (key === this.last) return;
    if (this.t_s.length && t_s <= this.t_s[this.t_s.length - 1]) return; // seen before, as after a seek
    this.last = key;
    this.t_s.push(t_s);
    this.rows.push(words);
  }

  /** @param {number} t_s */
  at(t_s) {
    const k = last(this.t_s, t_s);
    return this.rows[Math.max(k, 0)] ?? {};
  }
}

/** The last place whose time is not after `t_s`; -1 before the first. @param {ArrayLike<number>} times @param {number} t_s */
export function last(times, t_s, count = times.length) {
  let low = 0;
  let high = count;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] <= t_s) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

/** Whether a vehicle's path has a gap at a sample: its place is not known, or one from long before. @param {Record<Channel, Float32Array>} columns @param {number} k */
export const unseen = (columns, k) => Number.isNaN(columns.n[k]) || columns.age[k] > GAP_S;

export class Flight {
  /** @type {SessionLine | null} */
  session = null;
  /** @type {{t_s: number, session: SessionLine}[]} where obstacles and paths have changed: the session from each time on */
  worlds = [];
  /** @type {Snapshot | null} */
  newest = null;
  /** @type {EventRow[]} */
  events = [];
  count = 0;
  capacity = 256;
  spacing_s = FIRST_SPACING_S;
  t_s = new Float64Array(this.capacity);
  share = new Float32Array(this.capacity);
  /** @type {Map<number, Record<Channel, Float32Array>>} */
  columns = new Map();
  /** @type {Map<number, Words>} */
  words = new Map();
  /** @type {Map<string, Float32Array[]>} */
  traffic = new Map();
  /** other flights, shown beside this one @type {Flight[]} */
  ghosts = [];
  /** counts each change of the columns, for views that draw them */
  version = 0;

  /** Forget everything: another flight begins. */
  clear() {
    Object.assign(this, new Flight(), { version: this.version + 1 });
  }

  get first_s() {
    return this.count ? this.t_s[0] : 0;
  }

  get last_s() {
    return this.count ? this.t_s[this.count - 1] : 0;
  }

  /** The session is this from now on; that of a replay is of the time at which it is. @param {SessionLine} session */
  begin(session) {
    this.session = session;
    if (session.source === "replay") return;
    const t_s = this.worlds.length ? (this.newest?.t_s ?? 0) : -Infinity;
    while (this.worlds.length && this.worlds[this.worlds.length - 1].t_s >= t_s) this.worlds.pop();
    this.worlds.push({ t_s, session });
    if (this.worlds.length > MOST_WORLDS) this.worlds = this.worlds.filter((_, k) => k % 2 === 0);
  }

  /** The session with the obstacles and paths of a time. @param {number} t_s */
  sessionAt(t_s) {
    const k = last(this.worlds.map((one) => one.t_s), t_s);
    return this.worlds[Math.max(k, 0)]?.session ?? this.session;
  }

  /** @param {EventRow[]} events */
  tell(events) {
    if (!events.length) return;
    this.events.push(...events);
    if (this.events.length > MOST_EVENTS) this.events.splice(0, this.events.length - MOST_EVENTS);
  }

  /** @param {Snapshot} snapshot */
  take(snapshot) {
    this.newest = snapshot;
    const t_s = snapshot.t_s;
    for (const row of snapshot.vehicles) {
      let words = this.words.get(row.sysid);
      if (!words) this.words.set(row.sysid, (words = new Words()));
      words.take(t_s, row);
    }
    const before = last(this.t_s, t_s, this.count);
    const near = (/** @type {number} */ k) => k >= 0 && k < this.count && Math.abs(this.t_s[k] - t_s) < this.spacing_s;
    if (near(before) || near(before + 1)) return;
    this.#room();
    this.#insert(before + 1, snapshot);
    this.version += 1;
  }

  /** @param {number} at @param {Snapshot} snapshot */
  #insert(at, snapshot) {
    const moved = at < this.count;
    /** @param {Float32Array | Float64Array} column @param {number} value */
    const put = (column, value) => {
      if (moved) column.copyWithin(at + 1, at, this.count);
      column[at] = value;
    };
    put(this.t_s, snapshot.t_s);
    put(this.share, snapshot.competition.share ?? NaN);
    const told = new Set();
    for (const row of snapshot.vehicles) {
      told.add(row.sysid);
      const columns = this.#columnsOf(row.sysid);
      numbersOf(row).forEach((value, k) => put(columns[CHANNELS[k]], value));
    }
    for (const [sysid, columns] of this.columns) if (!told.has(sysid)) for (const name of CHANNELS) put(columns[name], NaN);
    const seen = new Set();
    for (const craft of snapshot.traffic) {
      seen.add(craft.callsign);
      const columns = this.#trafficOf(craft.callsign);
      craft.p_ned.forEach((value, k) => put(columns[k], value));
    }
    for (const [callsign, columns] of this.traffic) if (!seen.has(callsign)) for (const column of columns) put(column, NaN);
    this.count += 1;
  }

  /** @param {number} sysid */
  #columnsOf(sysid) {
    let columns = this.columns.get(sysid);
    if (!columns) {
      columns = /** @type {Record<Channel, Float32Array>} */ ({});
      for (const name of CHANNELS) columns[name] = new Float32Array(this.capacity).fill(NaN);
      this.columns.set(sysid, columns);
    }
    return columns;
  }

  /** @param {string} callsign */
  #trafficOf(callsign) {
    let columns = this.traffic.get(callsign);
    if (!columns) {
      columns = [0, 1, 2].map(() => new Float32Array(this.capacity).fill(NaN));
      this.traffic.set(callsign, columns);
    }
    return columns;
  }

  /** Room for one more: more memory, or every other sample dropped. */
  #room() {
    if (this.count < this.capacity) return;
    const most = Math.min(MOST_SAMPLES, Math.max(256, MOST_NUMBERS / (CHANNELS.length * Math.max(this.columns.size, 1))));
    if (2 * this.capacity <= most) {
      this.capacity *= 2;
      this.#change((column) => {
        const wider = new /** @type {any} */ (column.constructor)(this.capacity).fill(NaN);
        wider.set(column);
        return wider;
      });
      return;
    }
    const half = this.count >> 1;
    this.#change((column) => {
      for (let k = 0; k < half; k += 1) column[k] = column[2 * k];
      return column;
    });
    this.count = half;
    this.spacing_s = Math.max(2 * this.spacing_s, (0.9 * (this.last_s - this.first_s)) / Math.max(half, 1));
  }

  /** @param {(column: any) => any} change */
  #change(change) {
    this.t_s = change(this.t_s);
    this.share = change(this.share);
    for (const columns of this.columns.values()) for (const name of CHANNELS) columns[name] = change(columns[name]);
    for (const columns of this.traffic.values()) columns.forEach((column, k) => (columns[k] = change(column)));
  }

  /**
   * The snapshot of a time: the newest one at the end, else what the columns tell, between two samples in proportion.
   * @param {number} t_s @returns {Snapshot | null}
   */
  at(t_s) {
    const newest = this.newest;
    if (!newest || !this.count) return newest;
    const before = Math.max(last(this.t_s, t_s, this.count), 0);
    const after = Math.min(before + 1, this.count - 1);
    const span_s = this.t_s[after] - this.t_s[before];
    const part = span_s > 0 ? Math.min(Math.max((t_s - this.t_s[before]) / span_s, 0), 1) : 0;
    /** @param {Float32Array} column */
    const between = (column, turns = false) => {
      const a = column[before];
      let b = column[after];
      if (Number.isNaN(b) || Number.isNaN(a)) return part < 0.5 ? a : b;
      if (turns) b = a + Math.atan2(Math.sin(b - a), Math.cos(b - a));
      return a + part * (b - a);
    };
    const known = (/** @type {number} */ value) => (Number.isNaN(value) ? null : value);
    const members = new Map((this.session?.vehicles ?? []).map((member) => [member.sysid, member]));
    /** @type {VehicleRow[]} */
    const vehicles = [];
    for (const [sysid, columns] of this.columns) {
      const member = members.get(sysid);
      /** @type {any} */
      const at = {};
      for (const name of CHANNELS) at[name] = known(between(columns[name], TURNS.has(name)));
      const capacity_j = member?.capacity_j ?? null;
      const battery = at.battery === null ? null : at.battery / 100;
      vehicles.push(/** @type {VehicleRow} */ ({
        sysid, role: member?.role ?? "", label: member?.label ?? String(sysid), autopilot: null, alive: true, stage: "",
        mode: "", mode_name: "", armed: true, landed: false, state: "", note: "", trouble: [], severity: 0, condition: "", figure: "", urgency: 0,
        ...this.words.get(sysid)?.at(t_s),
        p_ned: at.n === null ? null : [at.n, at.e, at.d], v_ned: null, speed_m_s: at.speed, height_m: at.height,
        heading_rad: at.heading, roll_rad: at.roll, pitch_rad: at.pitch, aim_ned: null, margin_m: null,
        age_s: at.age, heard_s: null, lost: at.lost ?? 0, lost_share: null, target_m: at.target, battery,
        remaining_j: battery !== null && capacity_j !== null ? battery * capacity_j : null, power_w: at.power,
        endurance_s: null, energy_source: "", v: at.v, tau: null,
      }));
    }
    vehicles.sort((a, b) => a.sysid - b.sysid);
    const { services, history, refuelled } = this.#servicesAt(t_s);
    for (const row of vehicles) {
      if (row.state) continue; // a recording in the page tells none: a vehicle is what the refuellings make of it
      const service = services.find((one) => one.receiver === row.sysid || one.tanker === row.sysid);
      row.state = !service ? "" : service.tanker === row.sysid ? "serves" : service.phase === "transfer" ? "served" : "waits";
    }
    const traffic = [];
    for (const [callsign, columns] of this.traffic) {
      const p_ned = /** @type {[number, number, number]} */ (columns.map((column) => between(column)));
      if (!p_ned.some(Number.isNaN)) traffic.push({ callsign, p_ned, v_ned: /** @type {[number, number, number]} */ ([0, 0, 0]), age_s: 0 });
    }
    const v = Object.fromEntries(vehicles.filter((row) => row.v !== null).map((row) => [row.sysid, row.v]));
    const share = known(this.share[before]);
    const ids = Object.keys(v).sort((a, b) => Number(v[b]) - Number(v[a]));
    return {
      ...newest, t_s, vehicles, traffic, events: [], inspected: {},
      competition: {
        ...newest.competition, v: /** @type {Record<string, number>} */ (v), tau: {}, share,
        leader: share === null || !ids.length ? null : Number(ids[0]), runner_up: ids.length > 1 ? Number(ids[1]) : null,
      },
      services, history, refuelled,
      goal: { ...newest.goal, pursue_held_s: null, broken: newest.goal.broken.filter((one) => one.t_s === null || one.t_s <= t_s) },
    };
  }

  /** @param {number} t_s */
  #servicesAt(t_s) {
    const newest = /** @type {Snapshot} */ (this.newest);
    const history = newest.history.filter((one) => one.end_s !== null && one.end_s <= t_s);
    const ended = newest.history.filter((one) => one.decided_at_s <= t_s && (one.end_s === null || one.end_s > t_s));
    const open = newest.services.filter((one) => one.decided_at_s <= t_s);
    const services = ended.map((one) => /** @type {ServiceRow} */ ({
      receiver: one.receiver, tanker: one.tanker, base: one.base, by: one.by, energy_j: 0, decided_at_s: one.decided_at_s,
      phase: one.start_s !== null && one.start_s <= t_s ? "transfer" : "join",
      joined_at_s: one.joined_at_s !== null && one.joined_at_s <= t_s ? one.joined_at_s : null,
      rendezvous_ned: null, bids: {}, why: "",
    }));
    return { services: [...services, ...open], history, refuelled: history.filter((one) => one.energy_j > 0).length };
  }
}
