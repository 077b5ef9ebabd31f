// The page begins here: a flight on a server (live or replayed), or the recorded one that the page carries.
// @ts-check
import { App, SPEEDS } from "./app.js";
import { clock, h, say } from "./elements.js";
import { nextTheme, restoreTheme, usePalette } from "./look.js";
import { Live } from "./live.js";
import { Operator } from "./operator.js";
import { recorded } from "./recorded.js";
import { useConditions } from "./strip.js";
import { linkedTime } from "./timeline.js";
import { Tiles } from "./tiles.js";

/** @typedef {import("./operator.js").Order} Order */
/** @typedef {{palette: import("./look.js").Palette, orders: Order[], conditions: import("./strip.js").Condition[], source: "server" | "report", tiles: string | null}} Config */

const KEYS = [
  ["space", "pause, or go on"], ["← →", "10 s back or on (replay, report, or back in a live flight)"], ["< >", "slower, faster"], ["End", "back to the newest"],
  ["[ ]", "the vehicle before, after"], ["g", "go to a vehicle by its id"], ["/", "filter vehicles"], ["3 m", "in space, map"], ["c", "camera: free, follow, from its eyes"],
  ["0", "show everything"], ["v", "paths on or off"], ["d", "dark or light"], ["?", "this page"],
];
const SEEK_S = 10;

/** @param {import("./app.js").App} app @param {Order[]} orders @param {(order: Order) => void} ask */
function keyboard(app, orders, ask) {
  const help = h("dialog", { class: "ask", "aria-label": "keys" });
  const rows = [...KEYS, ...orders.map((order) => [order.key.toUpperCase(), order.what])].map(([key, what]) => h("tr", {}, h("th", { scope: "row" }, key), h("td", { class: "word" }, what)));
  help.append(h("h2", {}, "Keys"), h("table", {}, h("tbody", {}, ...rows)), h("form", { method: "dialog" }, h("button", {}, "Close")));
  document.body.append(help);
  /** @type {Record<string, () => void>} */
  const actions = {
    " ": () => app.player.toggle(), ArrowLeft: () => app.player.seek((app.time.now_s ?? 0) - SEEK_S), ArrowRight: () => app.player.seek(app.time.now_s + SEEK_S),
    "<": () => app.player.faster(-1), ">": () => app.player.faster(1), End: () => app.player.newest?.(),
    "[": () => app.chooseNext(-1), "]": () => app.chooseNext(1), g: () => app.table.goto.focus(), "/": () => app.table.filter.focus(),
    3: () => app.show("space"), m: () => app.show("map"), c: () => app.nextCamera(), 0: () => app.whole(), v: () => app.togglePaths(), d: () => nextTheme(),
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

/** @param {Config} config */
function served(config) {
  const root = /** @type {HTMLElement} */ (document.getElementById("app"));
  const title = h("h1", {}, "connecting …");
  const badge = h("span", { class: "badge" });
  const phase = h("span", { class: "badge phase" });
  const [broken, reached] = [h("b", { class: "bad" }), h("span")];
  const goal = h("p", { class: "soft small goal-line" }, broken, reached);
  const help = h("button", { type: "button" }, "keys ?");
  const theme = h("button", { type: "button", onclick: () => nextTheme() }, "dark / light");
  const state = h("p", { class: "connection", role: "alert" });
  state.hidden = true;
  const session = h("div", { class: "tools orders" });
  const top = h("header", { class: "top" }, h("div", { class: "tools" }, title, badge, phase, session, theme, help), goal, state);
  root.before(top);

  let replaying = false;
  let linked = false;
  /** @type {Record<string, any> | undefined} */
  let replay;
  let control = false;
  let ended = "";
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
  const ask = (/** @type {Order} */ order) => {
    if (!control) return void operator.notice(replaying ? "A recording takes no commands." : "View-only link: commands are disabled.", "bad");
    if (order.of_many && app.selected.size > 1) operator.askMany(order, [...app.selected], false, label, () => app.flight.newest);
    else operator.ask(order, app.chosen, label, () => app.flight.newest);
  };
  const label = (/** @type {number} */ id) => app.label(id);
  for (const order of config.orders.filter((one) => one.of_many && one.command !== "land")) {
    const everyone = () => (app.flight.newest?.vehicles ?? []).map((row) => row.sysid);
    app.strip.all.append(h("button", { type: "button", title: `${order.name} all vehicles`, onclick: () => operator.askMany(order, everyone(), true, label, () => app.flight.newest) }, `all: ${order.name}`));
  }
  help.addEventListener("click", keyboard(app, config.orders, ask).showModal.bind(document.querySelector("dialog[aria-label=keys]")));
  for (const order of config.orders) {
    const button = h("button", { type: "button", title: `${order.what} (Shift+${order.key.toUpperCase()})`, onclick: () => ask(order) }, order.name);
    (order.of_vehicle ? app.orders : session).append(button);
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
      document.title = `${line.name} – Skytender`;
      say(title, line.name);
      say(badge, ({ session: "live", monitor: "monitor", replay: "replay" })[line.source]);
      for (const part of [session, app.orders, app.strip.all]) part.hidden = !control;
      app.timeline.live.hidden = replaying;
      app.members();
    } else if (line.type === "snapshot") {
      replay = line.replay;
      app.flight.take(line);
      app.flight.tell(line.events);
      if (replaying) {
        app.begin_s = replay?.from_s;
        app.end_s = replay?.to_s;
        app.playing = !replay?.paused && line.phase !== "ended";
        app.speed = `×${replay?.speed ?? 1}`;
      } else {
        app.playing = line.phase !== "paused";
        app.speed = line.speed ? `×${line.speed.toFixed(line.speed < 10 ? 1 : 0)}` : "";
      }
      say(phase, `${line.phase} ${clock(line.t_s)}${line.duration_s ? ` of ${clock(line.duration_s)}` : ""}`);
      const { goal: wanted } = line;
      const held = wanted.pursue_for_s && wanted.pursue_held_s !== null ? `pursuit held ${wanted.pursue_held_s.toFixed(0)} of ${wanted.pursue_for_s.toFixed(0)} s` : "";
      const served = wanted.refuelled_at_least ? `${line.refuelled} refuelled, at least ${wanted.refuelled_at_least} wanted` : line.refuelled ? `${line.refuelled} refuelled` : "";
      const failed = wanted.broken.map((one) => one.text + (one.t_s === null ? "" : ` (${one.t_s.toFixed(1)} s)`));
      say(broken, failed.length ? `${failed.length} ${failed.length === 1 ? "goal" : "goals"} failed: ${failed.join("; ")}. ` : "");
      say(reached, [held, served].filter(Boolean).join("; "));
      goal.title = goal.textContent ?? "";
      app.dirty = true;
    } else if (line.type === "end") {
      ended = `The session has ended: ${line.text || line.outcome || "unknown"}. The page keeps what it has seen.`;
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
    state.className = `connection ${live.state === "ended" ? "soft" : "bad"}`;
    say(state, text);
    if (live.state === "refused") say(title, "no entry");
    document.documentElement.dataset.connection = live.state;
  };
  live.open();
  return Object.assign(app, { operator });
}

restoreTheme();
const config = /** @type {Config} */ (JSON.parse(document.getElementById("config")?.textContent ?? "{}"));
usePalette(config.palette);
useConditions(config.conditions);
const begun = config.source === "report" ? recorded(config, keyboard) : served(config);
Object.assign(window, { skytender: begun }); // for the console of a developer, and tests
