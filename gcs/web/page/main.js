// The page begins here: a flight on a server (live or replayed), or the recorded one that the page carries.
// @ts-check
import { App, SPEEDS } from "./app.js";
import { clock, h, key as keyOf, say } from "./elements.js";
import { nextTheme, restoreTheme, usePalette } from "./look.js";
import { Live } from "./live.js";
import { Operator } from "./operator.js";
import { recorded } from "./recorded.js";
import { Sound } from "./sound.js";
import { useConditions } from "./strip.js";
import { linkedTime } from "./timeline.js";
import { Tiles } from "./tiles.js";
import { Tour } from "./tour.js";

/** @typedef {import("./operator.js").Order} Order */
/** @typedef {{palette: import("./look.js").Palette, orders: Order[], conditions: import("./strip.js").Condition[], source: "server" | "report", tiles: string | null}} Config */

const KEYS = [
  ["space", "pause, or go on"], ["← →", "10 s back or on (replay, report, or back in a live flight)"], ["< >", "slower, faster"], ["End", "back to the newest"],
  ["[ ]", "the vehicle before, after"], ["g", "go to a vehicle by its id"], ["/", "filter vehicles"], ["3 m", "in space, map"], ["c", "camera: free, follow, from its eyes"],
  ["0", "show everything"], ["+ − 0", "in picture and figures: nearer, farther, everything"], ["v", "paths on or off"], ["b", "select all that are in the picture"], ["a", "select all that the table shows"], ["ctrl↵ ⇧↵", "on an id in the table: add it to the selection; it and those between"], ["Esc", "select none"], ["d", "dark or light"], ["?", "this page"],
];
const SEEK_S = 10;
const SILENT_S = 3; // as the console's header has it (gcs/console/pages/heading.py)
const SOURCES = { session: "live", monitor: "monitor", replay: "replay" };

/** @param {import("./app.js").App} app @param {Order[]} orders @param {(order: Order) => void} ask */
function keyboard(app, orders, ask) {
  const help = h("dialog", { class: "ask", "aria-label": "keys" });
  const rows = [...KEYS, ...orders.map((order) => [order.key.toUpperCase(), order.what, order.command])].map(([key, what, command]) => h("tr", command ? { "data-order": command } : {}, h("th", { scope: "row" }, key), h("td", { class: "word" }, what)));
  help.append(h("h2", {}, "Keys"), h("table", {}, h("tbody", {}, ...rows)), h("form", { method: "dialog" }, h("button", {}, "Close")));
  document.body.append(help);
  /** @type {Record<string, () => void>} */
  const actions = {
    " ": () => app.player.toggle(), ArrowLeft: () => app.player.seek((app.time.now_s ?? 0) - SEEK_S), ArrowRight: () => app.player.seek(app.time.now_s + SEEK_S),
    "<": () => app.player.faster(-1), ">": () => app.player.faster(1), End: () => app.player.newest?.(),
    "[": () => app.chooseNext(-1), "]": () => app.chooseNext(1), g: () => app.table.goto.focus(), "/": () => app.table.filter.focus(),
    3: () => app.show("space"), m: () => app.show("map"), c: () => app.nextCamera(), 0: () => app.whole(), v: () => app.togglePaths(), d: () => nextTheme(),
    b: () => app.selectInPicture(), a: () => app.selectAll(), Escape: () => app.choose(null),
    "?": () => help.showModal(),
  };
  document.addEventListener("keydown", (event) => {
    const target = /** @type {HTMLElement} */ (event.target);
    if (event.ctrlKey || event.metaKey || event.altKey || target.closest("dialog")) return;
    if (target.matches("input:not([type=range]), select, textarea")) {
      if (event.key === "Escape") target.blur();
      return;
    }
    if (target.matches("input[type=range]") && event.key.startsWith("Arrow")) return;
    if (target.matches("button, summary") && (event.key === " " || event.key === "Enter")) return;
    const order = orders.find((one) => one.key.toUpperCase() === event.key && event.shiftKey);
    if (order) ask(order);
    else if (actions[event.key]) actions[event.key]();
    else return;
    event.preventDefault();
  });
  return help;
}

/** `3 pursuers, 1 target`. @param {{role: string}[]} members */
function counted(members) {
  /** @type {Map<string, number>} */
  const counts = new Map();
  for (const { role } of members) counts.set(role, (counts.get(role) ?? 0) + 1);
  return [...counts].map(([role, count]) => `${count} ${role || "vehicle"}${count === 1 ? "" : "s"}`).join(", ") || "Vehicles";
}

/** @param {Config} config */
function served(config) {
  const root = /** @type {HTMLElement} */ (document.getElementById("app"));
  const title = h("h1", {}, "Starting …");
  const badge = h("span", { class: "badge" });
  const phase = h("span", { class: "badge phase" });
  const [broken, reached] = [h("b", { class: "bad" }), h("span")];
  const goal = h("p", { class: "soft small goal-line" }, broken, reached);
  const help = h("button", { type: "button" }, "keys ?");
  const theme = h("button", { type: "button", onclick: () => nextTheme() }, "dark / light", keyOf("D"));
  const sound = new Sound();
  const reported = h("a", { target: "_blank" }, "Open the report");
  reported.hidden = true;
  const words_of_state = h("span");
  const state = h("p", { class: "connection", role: "alert" }, words_of_state, " ", reported);
  state.hidden = true;
  const session = h("div", { class: "tools orders" });
  const top = h("header", { class: "top" }, h("div", { class: "tools" }, title, badge, phase, h("span", { class: "gap" }), session, sound.button, theme, help), goal, state);
  root.before(top);

  let replaying = false;
  let linked = false;
  /** @type {Record<string, any> | undefined} */
  let replay;
  let control = false;
  let ended = "";
  let broken_off = false;
  const player = {
    seek: (/** @type {number} */ t_s) => {
      if (replaying) live.send({ command: "seek", t_s }, refused);
      else {
        app.at_s = t_s >= app.flight.last_s - 0.05 ? null : Math.max(t_s, app.flight.first_s);
        app.dirty = true;
      }
    },
    toggle: () => {
      if (replaying) live.send({ command: replay?.paused || app.flight.newest?.phase === "ended" ? "resume" : "pause" }, refused);
      else ask(/** @type {Order} */ (config.orders.find((order) => order.command === "pause")));
    },
    faster: (/** @type {number} */ step) => {
      if (!replaying) return void operator.notice("Speed can be changed only in a replay.");
      const now = replay?.speed ?? 1;
      const nearest = SPEEDS.reduce((best, one, k) => (Math.abs(one - now) < Math.abs(SPEEDS[best] - now) ? k : best), 0);
      live.send({ command: "speed", speed: SPEEDS[Math.min(Math.max(nearest + step, 0), SPEEDS.length - 1)] }, refused);
    },
    newest: () => {
      app.at_s = null;
      app.dirty = true;
    },
  };
  const refused = (/** @type {boolean} */ ok, /** @type {string} */ text) => {
    if (!ok) operator.notice(text, "bad");
  };
  const app = new App(root, { charts: true, player });
  top.append(app.strip.element);
  if (config.tiles) app.map.tiles = new Tiles(config.tiles, () => (app.map.dirty = true));
  const operator = new Operator(config.orders, (command, answer) => live.send(command, answer));
  const plans = () => new Map((app.flight.session?.vehicles ?? []).map((one) => [one.sysid, one.plan_b]));
  const ask = (/** @type {Order} */ order) => {
    const refusal = live.state === "ended" ? "The session has ended: it takes no commands." : control ? "" : replaying ? "A recording takes no commands." : "View-only link: commands are disabled.";
    if (refusal) return void operator.notice(refusal, "bad");
    if (!operator.takes(order)) return void operator.notice(`A monitor takes no ${order.name}: it knows hold, return and land.`, "bad");
    if (order.of_many && app.selected.size > 1) operator.askMany(order, [...app.selected], false, label, () => app.flight.newest, plans());
    else operator.ask(order, app.chosen, label, () => app.flight.newest);
  };
  const label = (/** @type {number} */ id) => app.label(id);
  const starting = h("p", { class: "starting", role: "status" }, "The session is starting.");
  root.querySelector(".picture")?.append(starting);
  for (const part of [session, app.orders, app.strip.all, badge, phase]) part.hidden = true; // until it is known what is flown
  for (const order of config.orders.filter((one) => one.of_many && one.command !== "land")) {
    const everyone = () => (app.flight.newest?.vehicles ?? []).map((row) => row.sysid);
    app.strip.all.append(h("button", { type: "button", title: `${order.name} all vehicles`, onclick: () => operator.askMany(order, everyone(), true, label, () => app.flight.newest, plans()) }, `all: ${order.name}`));
  }
  help.addEventListener("click", keyboard(app, config.orders, ask).showModal.bind(document.querySelector("dialog[aria-label=keys]")));
  /** @type {Map<Order, HTMLElement>} */
  const buttons = new Map();
  for (const order of config.orders) {
    const button = h("button", { type: "button", title: `${order.what} (Shift+${order.key.toUpperCase()})`, onclick: () => ask(order) }, order.name, keyOf(`⇧${order.key.toUpperCase()}`));
    (order.of_vehicle ? app.orders : session).append(button);
    buttons.set(order, button);
  }

  const live = new Live((line) => {
    if (line.type === "session") {
      app.flight.begin(line);
      app.flight.tell(line.events ?? []);
      replaying = line.source === "replay";
      const linked_s = linkedTime();
      if (replaying && !linked && linked_s !== null) player.seek(linked_s);
      linked = true;
      control = Boolean(line.control) && !replaying;
      operator.monitors = line.source === "monitor";
      for (const [order, button] of buttons) {
        const row = /** @type {HTMLElement | null} */ (document.querySelector(`dialog tr[data-order=${order.command}]`));
        button.hidden = !operator.takes(order);
        if (row) row.hidden = button.hidden;
      }
      document.title = `${line.name} – Skytender`;
      say(title, line.name);
      for (const part of [session, app.orders, app.strip.all]) part.hidden = !control;
      connection();
      say(starting, `${counted(line.vehicles)} ${line.vehicles.length === 1 ? "starts" : "start"}; they are shown here as soon as they report.`);
      app.timeline.live.hidden = replaying;
      app.members();
    } else if (line.type === "snapshot") {
      replay = line.replay;
      app.flight.take(line);
      app.flight.tell(line.events);
      sound.watch(line);
      if (replaying) {
        app.begin_s = replay?.from_s;
        app.end_s = replay?.to_s;
        app.playing = !replay?.paused && line.phase !== "ended";
        app.speed = `×${replay?.speed ?? 1}`;
      } else {
        app.playing = line.phase !== "paused";
        app.speed = line.speed ? `×${line.speed.toFixed(line.speed < 10 ? 1 : 0)}` : "";
      }
      connection();
      starting.hidden = true;
      say(phase, `${line.phase} ${clock(line.t_s)}${line.duration_s ? ` of ${clock(line.duration_s)}` : ""}`);
      const { goal: wanted } = line;
      const held = wanted.pursue_for_s && wanted.pursue_held_s !== null ? `pursuit held ${wanted.pursue_held_s.toFixed(0)} of ${wanted.pursue_for_s.toFixed(0)} s` : "";
      const served = wanted.refuelled_at_least ? `${line.refuelled} refuelled, at least ${wanted.refuelled_at_least} wanted` : line.refuelled ? `${line.refuelled} refuelled` : "";
      const failed = wanted.broken.map((one) => one.text); // which say when
      say(broken, failed.length ? `${failed.length} ${failed.length === 1 ? "goal" : "goals"} failed: ${failed.join("; ")}. ` : "");
      say(reached, [held, served].filter(Boolean).join("; "));
      goal.title = goal.textContent ?? "";
      app.dirty = true;
    } else if (line.type === "end") {
      broken_off = app.flight.newest?.phase !== "ended";
      ended = `The session has ${broken_off ? "broken off" : "ended"}: ${line.text.replace(/\.$/, "")}. The page keeps what it has seen.`;
      if (!broken_off) say(broken, ""); // the result names every part of the goal that was not met
      for (const part of [session, app.orders, app.strip.all]) part.hidden = true; // there is no vehicle left to obey
      connection();
    } else if (line.type === "report") {
      reported.href = line.path;
      reported.hidden = false;
      connection();
    }
  }, () => connection(), () => app.flight.clear());
  const connection = () => {
    const words = {
      connecting: "", open: "", ended,
      lost: "The connection is lost; the page tries again by itself. What is shown is the last that came.",
      refused: "This link lacks its token, or the token is of another session: open the whole link that `gcs` printed.",
    };
    const text = words[live.state];
    state.hidden = !text;
    state.className = `connection ${live.state === "ended" && !broken_off ? "soft" : "bad"}`;
    say(words_of_state, text);
    if (live.state === "refused") say(title, "no entry");
    if (live.state === "ended" && !app.flight.session) say(title, "no session");
    if (live.state === "refused" || live.state === "ended") starting.hidden = true;
    reception();
    document.documentElement.dataset.connection = live.state;
  };
  /** Whether the session speaks: of one that does not, no phase and no speed are known; of one that has ended, nothing is said to be well. */
  const reception = () => {
    const { session: known, newest } = app.flight;
    const quiet = live.state === "open" && !replaying && newest !== null && live.silent_s >= SILENT_S;
    const over = live.state === "ended";
    const wrong = live.state === "lost" ? "not connected" : quiet ? `no news for ${live.silent_s.toFixed(0)} s` : over && broken_off ? "broken off" : "";
    const stale = wrong !== "" || over;
    badge.hidden = !known || (over && !wrong); // the phase says that it has ended
    badge.className = `badge ${wrong ? (quiet ? "warn" : "bad") : ""}`;
    if (known) say(badge, wrong || SOURCES[known.source]);
    phase.hidden = !newest || wrong !== "";
    if (app.strip.stale !== stale) {
      app.strip.stale = stale;
      app.paneled = null;
      app.dirty = true;
    }
    if (!stale || app.speed === "") return;
    app.speed = "";
    app.dirty = true;
  };
  setInterval(reception, 500);
  live.open();
  const tour = new Tour();
  tour.first();
  document.querySelector("dialog[aria-label=keys] form")?.append(h("button", { onclick: () => tour.go(0) }, "Show the tour"));
  return Object.assign(app, { operator, sound });
}

restoreTheme();
const config = /** @type {Config} */ (JSON.parse(document.getElementById("config")?.textContent ?? "{}"));
usePalette(config.palette);
useConditions(config.conditions);
const begun = config.source === "report" ? recorded(config, keyboard) : served(config);
Object.assign(window, { skytender: begun }); // for the console of a developer, and tests
