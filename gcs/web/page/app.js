// The page of a flight: live, replayed or recorded. It holds what has been seen, the time that is shown, and the chosen vehicles.
// @ts-check
import { Box, within } from "./box.js";
import { SharedTime, TimeChart } from "./charts.js";
import { h, key, number, say } from "./elements.js";
import { Flight } from "./flight.js";
import { Hover } from "./hover.js";
import { colourOf, nextTheme, onLook, setMembers } from "./look.js";
import { MapView } from "./map.js";
import { EventList, showContest, showVehicle } from "./panels.js";
import { plansOf, showPlans } from "./plans.js";
import { SpaceView } from "./space.js";
import { Strip } from "./strip.js";
import { FleetTable } from "./table.js";
import { Timeline } from "./timeline.js";

/** @typedef {import("./messages").SnapshotMessage} Snapshot */
/** @typedef {import("./charts.js").Figure} Figure */
/** @typedef {import("./flight.js").Channel} Channel */

export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10, 20, 50, 100];
const MANY = 16;
const TRAIL_S = 20; // of what moves in space, and of many on the map, only what was flown last is drawn
const CHARTS_MS = 500;
const BAND_POINTS = 300;
const PANELS_MS = 200;

/** @type {{title: string, unit: string, digits: number, channel: Channel, zero?: boolean, range?: [number, number]}[]} */
const CHARTS = [
  { title: "Distance to target", unit: "m", digits: 2, channel: "target", zero: true },
  { title: "Battery", unit: "%", digits: 1, channel: "battery", zero: true },
  { title: "Height", unit: "m", digits: 2, channel: "height" },
  { title: "Speed", unit: "m/s", digits: 2, channel: "speed", zero: true },
  { title: "State v of each competitor", unit: "", digits: 3, channel: "v", range: [-0.03, 1.06] },
  { title: "Frames lost so far", unit: "", digits: 0, channel: "lost", zero: true },
];

export class App {
  /**
   * @param {HTMLElement} root
   * @param {{charts: boolean, player: import("./timeline.js").Player}} options `charts`: figures of what has been seen
   */
  constructor(root, { charts, player }) {
    this.flight = new Flight();
    this.time = new SharedTime();
    /** @type {number | null} null: the newest */
    this.at_s = null;
    /** @type {number | null} */
    this.chosen = null;
    /** all that are selected, the chosen one among them @type {Set<number>} */
    this.selected = new Set();
    /** vehicles that figures draw singly @type {Set<number>} */
    this.shown = new Set();
    this.given = false;
    this.paths = true;
    /** whether paths are drawn whole while nothing moves */
    this.whole_paths = false;
    this.view = "space";
    this.player = player;
    this.playing = true;
    this.speed = "";
    /** what the line of time spans, where that is more than what has been seen @type {number | undefined} */
    this.begin_s = undefined;
    /** @type {number | undefined} */
    this.end_s = undefined;
    this.dirty = true;
    this.drawn_ms = 0;
    this.frames = 0;
    /** @type {(() => void)[]} */
    this.after = [];
    /** @type {Snapshot | null} */
    this.current = null;
    /** @type {Snapshot | null} */
    this.paneled = null;
    /** @type {Set<number> | null} */
    this.paneledFor = null;
    this.charted = -1;
    this.charted_at = 0;
    this.shown_at = 0;
    this.time.seek = (t_s) => player.seek(t_s);
    /** @type {() => void} */
    this.drawnFirst = () => {};
    /** is kept when the fleet has been drawn */
    this.first = new Promise((resolve) => (this.drawnFirst = () => resolve(null)));

    const choose = (/** @type {number | null} */ sysid, /** @type {MouseEvent} */ event) => this.pick(sysid, event);
    this.strip = new Strip((sysids) => this.select(sysids));
    const space = h("canvas", { class: "space", tabindex: 0, role: "img", "aria-label": "the fleet in space; arrow keys turn, + and − zoom, 0 shows everything, b selects all in the picture" });
    const names = h("canvas", { class: "names", "aria-hidden": "true" });
    const map = h("canvas", { class: "map", tabindex: 0, role: "img", "aria-label": "the fleet from above, north up; arrow keys move, + and − zoom, 0 shows everything, b selects all in the picture" });
    this.views = { space: h("button", { type: "button", onclick: () => this.show("space") }, "3-D", key("3")), map: h("button", { type: "button", onclick: () => this.show("map") }, "map", key("M")) };
    this.camera = h("select", { "aria-label": "camera", onchange: () => this.setCamera(this.camera.value) },
      h("option", { value: "free" }, "free view"), h("option", { value: "follow" }, "follow chosen"), h("option", { value: "first" }, "from its eyes"));
    const whole = h("button", { type: "button", onclick: () => this.whole() }, "show all", key("0"));
    this.pathsButton = h("button", { type: "button", "aria-pressed": "true", onclick: () => this.togglePaths() }, "paths", key("V"));
    this.wind = h("span", { class: "soft wind" });
    const picture = h("div", { class: "picture" }, space, names, map);
    this.box = new Box(picture, { places: () => this.places, take: (sysids, add) => this.select(add ? [...new Set([...this.selected, ...sysids])] : sysids), pick: choose });
    this.hover = new Hover(picture, () => ({ places: this.places, rows: this.current?.vehicles ?? [] }));
    const tools = h("div", { class: "tools" }, this.views.space, this.views.map, this.camera, whole, this.pathsButton, this.box.button, this.wind);
    const scene = h("section", { class: "card scene", "aria-label": "picture" }, tools, picture);
    const timelineAt = h("section", { class: "card time-line", "aria-label": "time" });
    const fleet = h("section", { class: "card", "aria-label": "fleet" }, h("h2", {}, "Fleet"));
    const vehicle = h("section", { class: "card vehicle", "aria-label": "vehicle" }, h("h2", {}, "Vehicle"));
    const contest = h("section", { class: "card contest", "aria-label": "competition and refuelling" }, h("h2", {}, "Competition and refuelling"));
    const events = h("section", { class: "card", "aria-label": "events" }, h("h2", {}, "Events"));
    this.vehicleAt = h("div", { class: "vehicle-page" });
    this.orders = h("div", { class: "tools orders" });
    this.selection = h("p", { class: "small selection", "aria-live": "polite" });
    vehicle.append(this.selection, this.orders, this.vehicleAt);
    this.contestAt = h("div");
    contest.append(this.contestAt);
    this.plansAt = h("div", { class: "plans" });
    this.plansCard = h("section", { class: "card", "aria-label": "missions and fences" }, h("h2", {}, "Missions and fences"), this.plansAt);
    this.plansCard.hidden = true;
    root.append(h("div", { class: "flight" },
      h("div", { class: "wide" }, scene, timelineAt), h("div", { class: "narrow" }, fleet, vehicle), h("div", { class: "narrow" }, this.plansCard, contest, events)));
    this.map = new MapView(map, choose);
    try {
      this.space = new SpaceView(space, names, choose);
    } catch {
      this.space = null; // no WebGL here: the map shows everything but heights
      this.views.space.disabled = true;
    }
    this.timeline = new Timeline(timelineAt, player);
    this.table = new FleetTable(fleet, (sysid, go, event) => {
      this.pick(sysid, event);
      if (go) this.setCamera("follow");
    });
    this.events = new EventList(events, (event) => {
      if (event.sysid > 0 && event.sysid < 255) this.choose(event.sysid);
      player.seek(event.t_s);
    });
    /** @type {{chart: TimeChart, div: HTMLElement, make: () => Figure, seen: boolean}[]} */
    this.charts = [];
    this.picker = null;
    if (charts) this.#addCharts(root);
    this.show(this.space ? "space" : "map");
    onLook(() => {
      this.dirty = true;
      this.charted_at = 0;
      if (this.space) this.space.pathsOf.version = -1;
      this.table.again();
      this.fillPicker();
    });
    new ResizeObserver(() => (this.dirty = true)).observe(picture);
    const tick = () => {
      requestAnimationFrame(tick); // first, so that a frame that fails is not the last
      this.#tick();
    };
    requestAnimationFrame(tick);
  }

  /** @param {HTMLElement} root */
  #addCharts(root) {
    this.picker = h("fieldset", { class: "picker" }, h("legend", {}, "Vehicles:"));
    const grid = h("div", { class: "figures" });
    root.append(h("section", { class: "charts", "aria-label": "charts" }, h("h2", {}, "Over time"), this.picker, grid));
    const seen = new IntersectionObserver((entries) => {
      for (const entry of entries) {
        const one = this.charts.find((chart) => chart.div === entry.target);
        if (one) one.seen = entry.isIntersecting;
        this.charted_at = 0;
      }
    });
    for (const kind of CHARTS) {
      const div = h("div", { class: "plot", role: "img", "aria-label": `${kind.title} over time` });
      grid.append(h("figure", {}, div));
      this.charts.push({ chart: new TimeChart(div, this.time, (id) => this.label(id)), div, make: () => this.#figure(kind), seen: false });
      seen.observe(div);
    }
  }

  /** @param {typeof CHARTS[number]} kind @returns {Figure} */
  #figure(kind) {
    const { flight } = this;
    const x = flight.t_s.subarray(0, flight.count);
    const lines = [];
    for (const [id, columns] of flight.columns) {
      const y = columns[kind.channel].subarray(0, flight.count);
      if (this.shown.has(id) && y.some((value) => !Number.isNaN(value))) lines.push({ id, x, y });
    }
    const goal = flight.newest?.goal;
    const limits = kind.channel === "target" && goal?.pursue_within_m ? [{ y: goal.pursue_within_m, label: `goal: within ${goal.pursue_within_m} m` }] : [];
    const band = flight.columns.size > MANY ? this.#band(kind.channel) : undefined;
    const served = kind.channel === "battery" || kind.channel === "v" ? [...(flight.newest?.history ?? []), ...(flight.newest?.services ?? [])] : [];
    const marks = kind.channel === "v" ? served.map((one) => ({ t_s: one.decided_at_s, id: one.receiver, label: `→ ${one.receiver}` })) : [];
    const spans = kind.channel !== "battery" ? [] : (flight.newest?.history ?? []).filter((one) => one.start_s !== null && this.shown.has(one.receiver))
      .map((one) => ({ from: one.start_s ?? 0, to: one.end_s ?? flight.last_s, id: one.receiver }));
    return { panels: [{ ...kind, limits, lines, own: [], band }], marks, spans };
  }

  /** Least, median and greatest of all vehicles. @param {Channel} channel */
  #band(channel) {
    const { flight } = this;
    const step = Math.max(Math.floor(flight.count / BAND_POINTS), 1);
    const columns = [...flight.columns.values()].map((one) => one[channel]);
    /** @type {number[][]} */
    const [x, least, median, greatest] = [[], [], [], []];
    for (let k = 0; k < flight.count; k += step) {
      const values = Float32Array.from(columns, (column) => column[k]).filter((value) => !Number.isNaN(value)).sort();
      x.push(flight.t_s[k]);
      least.push(values[0] ?? NaN);
      median.push(values[values.length >> 1] ?? NaN);
      greatest.push(values[values.length - 1] ?? NaN);
    }
    return { least: { x, y: least }, median: { x, y: median }, greatest: { x, y: greatest }, count: columns.length };
  }

  /** @param {number} id */
  label(id) {
    return this.flight.session?.vehicles.find((one) => one.sysid === id)?.label ?? `vehicle ${id}`;
  }

  /** The vehicles have become known, or have changed. */
  members() {
    const members = this.flight.session?.vehicles ?? [];
    setMembers(members);
    if (!this.given) {
      this.shown = new Set(members.length > MANY ? [] : members.map((one) => one.sysid));
    }
    if (this.space) this.space.madeOf = null;
    this.plansCard.hidden = !plansOf(this.flight.session).length;
    const wind = this.flight.session?.wind;
    say(this.wind, wind ? `wind ${number(wind.speed_m_s, 1)} m/s from ${number(wind.from_deg, 0)}°` : "");
    this.fillPicker();
    this.dirty = true;
  }

  fillPicker() {
    if (!this.picker) return;
    const members = this.flight.session?.vehicles ?? [];
    const listed = members.length > MANY ? members.filter((one) => this.shown.has(one.sysid)) : members;
    const buttons = listed.map((one) => {
      const swatch = h("i", { class: "swatch" });
      swatch.style.background = colourOf(one.sysid);
      return h("button", { type: "button", "aria-pressed": String(this.shown.has(one.sysid)), onclick: () => this.toggle(one.sysid) }, swatch, one.label);
    });
    this.picker.replaceChildren(h("legend", {}, members.length > MANY ? "Drawn singly:" : "Vehicles:"), ...buttons);
    if (members.length > MANY) {
      const select = h("select", { "aria-label": "draw one more vehicle singly", onchange: () => select.value && this.toggle(Number(select.value)) },
        h("option", { value: "" }, "one more …"), ...members.filter((one) => !this.shown.has(one.sysid)).map((one) => h("option", { value: one.sysid }, one.label)));
      const what = "The ground is from the least to the greatest of all vehicles, dotted their median.";
      this.picker.append(select, h("span", { class: "small soft" }, what));
    }
  }

  /** @param {number} id */
  toggle(id) {
    if (!this.shown.delete(id)) this.shown.add(id);
    this.given = true;
    this.fillPicker();
    this.charted_at = 0;
    this.after.forEach((then) => then());
  }

  /** @param {number | null} sysid */
  choose(sysid) {
    this.select(sysid === null ? [] : [sysid]);
  }

  /** A click on a vehicle: with Shift, Ctrl or ⌘ it joins or leaves the selection. @param {number | null} sysid @param {MouseEvent | KeyboardEvent} [event] */
  pick(sysid, event) {
    if (sysid === null || !(event?.shiftKey || event?.ctrlKey || event?.metaKey)) return this.choose(sysid);
    const span = event.shiftKey && this.chosen !== null ? this.table.between(this.chosen, sysid, event) : null;
    if (span) return this.select([...new Set([sysid, ...span, ...this.selected])]);
    const others = [...this.selected].filter((one) => one !== sysid);
    this.select(this.selected.has(sysid) ? others : [sysid, ...others]);
  }

  /** Other flights, shown beside this one. */
  get ghosts() {
    return this.flight.ghosts;
  }

  set ghosts(flights) {
    this.flight.ghosts = flights;
    this.flight.version += 1; // what the picture covers is another
    if (this.space) this.space.madeOf = null;
    this.dirty = true;
  }

  /** Where the vehicles are drawn in the view that is shown. */
  get places() {
    return (this.view === "space" ? this.space?.places : this.map.places) ?? [];
  }

  /** Select every vehicle that is in the picture: a box that needs no pointer. */
  selectInPicture() {
    const { width, height } = (this.view === "space" && this.space ? this.space.canvas : this.map.canvas).getBoundingClientRect();
    this.select(within(this.places, [0, 0], [width, height]));
  }

  /** Select all that the table shows. */
  selectAll() {
    this.select(this.table.shown);
  }

  /** Select these alone; the first is the chosen one. @param {number[]} sysids */
  select(sysids) {
    const sysid = sysids[0] ?? null;
    this.chosen = sysid;
    this.selected = new Set(sysids);
    say(this.selection, sysids.length > 1 ? `${sysids.length} vehicles selected: hold, return and land go to all of them.` : "");
    const many = (this.flight.session?.vehicles.length ?? 0) > MANY;
    if (many && sysid !== null && !this.shown.has(sysid)) this.toggle(sysid);
    if (sysid === null) this.setCamera("free");
    this.dirty = true;
  }

  /** @param {number} step */
  chooseNext(step) {
    const ids = (this.flight.session?.vehicles ?? []).map((one) => one.sysid).sort((a, b) => a - b);
    if (!ids.length) return;
    const k = this.chosen === null ? (step > 0 ? -1 : 0) : ids.indexOf(this.chosen);
    this.choose(ids[(k + step + ids.length) % ids.length]);
  }

  /** @param {string} view */
  show(view) {
    this.view = view === "space" && this.space ? "space" : "map";
    for (const [name, button] of Object.entries(this.views)) button.setAttribute("aria-pressed", String(name === this.view));
    this.map.canvas.hidden = this.view !== "map";
    if (this.space) this.space.canvas.hidden = this.space.names.hidden = this.view !== "space";
    this.setCamera(this.camera.value);
  }

  /** @param {string} mode */
  setCamera(mode) {
    this.camera.value = mode;
    if (this.space) this.space.mode = /** @type {any} */ (mode);
    this.map.follow = mode !== "free";
    this.dirty = true;
  }

  nextCamera() {
    const modes = ["free", "follow", "first"];
    this.setCamera(modes[(modes.indexOf(this.camera.value) + 1) % modes.length]);
  }

  whole() {
    this.setCamera("free");
    this.map.whole();
    this.space?.whole();
    this.dirty = true;
  }

  togglePaths() {
    this.paths = !this.paths;
    this.pathsButton.setAttribute("aria-pressed", String(this.paths));
    this.dirty = true;
  }

  nextTheme() {
    nextTheme();
  }

  /** What is shown now. @returns {Snapshot | null} */
  present() {
    const { flight, at_s } = this;
    return at_s === null ? flight.newest : flight.at(at_s);
  }

  #tick() {
    const now = performance.now();
    const moving = (this.view === "space" ? this.space?.dirty : this.map.dirty) ?? false;
    if (!this.dirty && !moving) return void this.#late(now);
    const snapshot = this.present();
    if (!snapshot) return;
    this.dirty = false;
    this.map.dirty = false;
    if (this.space) this.space.dirty = false;
    const t_s = this.at_s ?? snapshot.t_s;
    const options = { chosen: this.chosen, selected: this.selected, paths: this.paths, until_s: t_s, trail_s: this.whole_paths && !this.playing ? Infinity : TRAIL_S, ghosts: this.ghosts };
    if (this.view === "space") this.space?.draw(this.flight, snapshot, options);
    else this.map.draw(this.flight, snapshot, options);
    this.frames += 1;
    this.drawnFirst();
    this.current = snapshot;
    this.hover.show();
    this.time.begin_s = this.flight.first_s;
    this.time.end_s = Math.max(this.flight.last_s, this.end_s ?? 0);
    this.time.setNow(t_s);
    this.timeline.show({
      now_s: t_s, begin_s: this.begin_s ?? this.flight.first_s, end_s: this.end_s ?? Math.max(this.flight.last_s, snapshot.t_s), playing: this.playing,
      speed: this.speed, following: this.at_s === null, events: this.flight.events,
    });
    this.#late(now);
  }

  /** What need not be drawn at every frame. @param {number} now */
  #late(now) {
    const snapshot = this.current;
    if (snapshot && now - this.shown_at > (this.flight.columns.size > MANY ? 2.5 : 1) * PANELS_MS && this.paneled !== snapshot) {
      this.shown_at = now;
      this.paneled = snapshot;
      this.table.show(snapshot, this.chosen, this.selected);
      const flies = this.player.newest !== null; // then the orders beside the strip act on the present, whatever is shown
      this.strip.show((flies && this.flight.newest) || snapshot);
      showPlans(this.plansAt, this.flight.session, snapshot);
      showContest(this.contestAt, snapshot, (id) => this.label(id));
      showVehicle(this.vehicleAt, snapshot, this.chosen, this.flight.session);
      this.events.show(this.flight.events, this.at_s ?? Infinity, (id) => this.label(id));
      return;
    }
    if (snapshot && this.paneledFor !== this.selected) {
      this.paneledFor = this.selected;
      this.table.show(snapshot, this.chosen, this.selected);
      showVehicle(this.vehicleAt, snapshot, this.chosen, this.flight.session);
    }
    if (this.charts.length && now - this.charted_at > (this.flight.columns.size > MANY ? 2 : 1) * CHARTS_MS && this.charted !== this.flight.version) {
      this.charted_at = now;
      this.charted = this.flight.version;
      for (const one of this.charts) if (one.seen) one.chart.draw(one.make(), this.shown);
    }
    if (this.charted_at === 0) this.charted = -1;
  }
}
