// The competition and the services with their reasons, the events, and one vehicle's page.
// @ts-check
import { clock, h, number, say } from "./elements.js";
import { colourOf } from "./look.js";
import { planText } from "./operator.js";
import { modeOf } from "./signs.js";

/** @typedef {import("./messages").SnapshotMessage} Snapshot */
/** @typedef {import("./messages").EventRow} EventRow */
/** @typedef {import("./messages").VehicleRow} VehicleRow */

const MOST_EVENTS = 300;
const FOLD_S = 0.35;

/** Replace an element's children only where what they say has changed. @param {HTMLElement} at @param {string} key @param {() => (Node | string)[]} make */
function renew(at, key, make) {
  if (at.dataset.key === key) return;
  at.dataset.key = key;
  at.replaceChildren(...make());
}

/** @param {HTMLElement} at @param {Snapshot} snapshot @param {(sysid: number) => string} label */
export function showContest(at, snapshot, label) {
  const { competition, services, history } = snapshot;
  const ids = Object.keys(competition.v).map(Number).sort((a, b) => competition.v[b] - competition.v[a] || a - b).slice(0, 12);
  const key = JSON.stringify([ids.map((id) => competition.v[id].toFixed(2)), competition.leader, competition.share?.toFixed(2), services, history.length]);
  renew(at, key, () => {
    /** @type {Node[]} */
    const made = [];
    if (ids.length) {
      const share = competition.share === null ? "" : `, ${number(100 * competition.share, 0)} % (${number(100 * competition.threshold, 0)} % needed to win)`;
      made.push(h("p", {}, competition.leader === null ? "No vehicle leads yet." : h("b", {}, `${label(competition.leader)} leads`), share));
      for (const id of ids) {
        const bar = h("span", { class: "bar" });
        bar.style.width = `${Math.min(Math.max(100 * competition.v[id], 0), 100)}%`;
        bar.style.background = colourOf(id);
        made.push(h("div", { class: "row" }, h("span", { class: "row-name" }, label(id)), h("div", { class: "track stack" }, bar), h("span", { class: "value" }, number(competition.v[id], 2))));
      }
    } else {
      made.push(h("p", { class: "soft" }, "No vehicle competes at this time."));
    }
    for (const one of services) {
      const giver = one.tanker === null ? `base ${one.base}` : label(one.tanker);
      const phase = one.phase === "transfer" ? `${number(one.energy_j / 1e3, 1)} kJ so far` : one.joined_at_s === null ? "on the way" : "in formation";
      made.push(h("div", { class: "service" }, h("b", {}, `${giver} → ${label(one.receiver)}: ${one.phase}`), ` ${phase}`,
        h("p", { class: "small soft" }, one.why || `decided at ${one.decided_at_s.toFixed(1)} s by ${one.by}`)));
    }
    if (history.length) {
      const rows = [...history].reverse().slice(0, 12).map((one) => h("tr", {}, ...[label(one.receiver), one.tanker === null ? `base ${one.base}` : label(one.tanker), one.by, number(one.decided_at_s, 1), number(one.end_s, 1), number(one.energy_j / 1e3, 1), one.reason].map((text, k) => h("td", { class: [0, 1, 2, 6].includes(k) ? "word" : "" }, text))));
      const heads = ["receiver", "by", "decided by", "decided s", "done s", "kJ", "ended"];
      made.push(h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "refuellings" }, h("table", {}, h("caption", {}, `${history.length} refuellings have ended`), h("thead", {}, h("tr", {}, ...heads.map((name, k) => h("th", { scope: "col", class: [0, 1, 2, 6].includes(k) ? "word" : "" }, name)))), h("tbody", {}, ...rows))));
    }
    return made;
  });
}

/** Events of one instant and vehicle, shown as one. @param {EventRow[]} events */
export function folded(events) {
  /** @type {{head: EventRow, more: EventRow[]}[]} */
  const groups = [];
  const order = { critical: 0, warning: 1, info: 2 };
  for (const event of events) {
    const group = groups[groups.length - 1];
    if (group && group.head.sysid === event.sysid && event.t_s - group.head.t_s <= FOLD_S && order[event.level] >= 2 && group.head.level === "info") group.more.push(event);
    else groups.push({ head: event, more: [] });
  }
  return groups;
}

export class EventList {
  /** @param {HTMLElement} parent @param {(event: EventRow) => void} go */
  constructor(parent, go) {
    this.go = go;
    this.search = h("input", { type: "search", placeholder: "search events", "aria-label": "search events", oninput: () => this.again() });
    this.level = h("select", { "aria-label": "level of events", onchange: () => this.again() }, h("option", { value: "info" }, "all"), h("option", { value: "warning" }, "warnings and errors"));
    this.list = h("ol", { class: "events" });
    parent.append(h("div", { class: "tools" }, this.search, this.level), h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "list of events" }, this.list));
    this.key = "";
  }

  again() {
    this.key = "";
    if (this.last) this.show(this.last.events, this.last.until_s, this.last.label);
  }

  /** @param {EventRow[]} events @param {number} until_s @param {(sysid: number) => string} label */
  show(events, until_s, label) {
    this.last = { events, until_s, label };
    let count = events.length;
    while (count > 0 && events[count - 1].t_s > until_s + 0.05) count -= 1;
    const key = `${count} ${events.length ? events[Math.max(count - 1, 0)]?.text : ""}`;
    if (key === this.key) return;
    this.key = key;
    const wanted = this.search.value.trim().toLowerCase();
    const worst = this.level.value === "warning";
    const shown = [];
    for (let k = count - 1; k >= 0 && shown.length < MOST_EVENTS; k -= 1) {
      const event = events[k];
      if (worst && event.level === "info") continue;
      if (wanted && !`${who(event, label)} ${event.text}`.toLowerCase().includes(wanted)) continue;
      shown.push(event);
    }
    const items = folded(shown.reverse()).reverse().map(({ head, more }) => {
      const line = (/** @type {EventRow} */ event) => [h("time", {}, clock(event.t_s)), h("span", { class: "who" }, who(event, label)), h("span", {}, event.text)];
      const item = h("li", { class: head.level });
      const button = h("button", { type: "button", class: "link", "aria-label": `go to ${clock(head.t_s)}`, onclick: () => this.go(head) }, ...line(head));
      item.append(button);
      if (more.length) item.append(h("details", {}, h("summary", {}, `and ${more.length} more`), ...more.map((event) => h("p", {}, ...line(event)))));
      return item;
    });
    this.list.replaceChildren(...(items.length ? items : [h("li", { class: "soft" }, "No events.")]));
  }
}

/** @param {EventRow} event @param {(sysid: number) => string} label */
function who(event, label) {
  return event.sysid === 0 ? "session" : event.sysid === 255 ? "traffic" : label(event.sysid);
}

/** One vehicle's page. @param {HTMLElement} at @param {Snapshot} snapshot @param {number | null} sysid @param {import("./messages").SessionLine | null} session */
export function showVehicle(at, snapshot, sysid, session) {
  const row = snapshot.vehicles.find((one) => one.sysid === sysid);
  if (!row) {
    renew(at, "none", () => [h("p", { class: "soft" }, "Choose a vehicle in the table or in the picture.")]);
    return;
  }
  const degrees = (/** @type {number | null} */ rad) => number(rad === null ? null : (rad * 180) / Math.PI, 0, "°");
  /** @type {[string, string][]} */
  const facts = [
    ["state", [row.state, row.stage].filter(Boolean).join(", ") || "–"], ["mode", modeOf(row) || "–"], ["autopilot", row.autopilot ?? "–"],
    ["armed", !row.alive ? "–" : row.armed ? (row.landed ? "armed, landed" : "armed, in the air") : "disarmed"],
    ["battery", row.battery === null ? "–" : `${number(100 * row.battery, 1)} %${row.remaining_j === null ? "" : `, ${number(row.remaining_j / 1e3, 1)} kJ`}`],
    ...(row.batteries ?? []).map((one) => /** @type {[string, string]} */ ([`battery ${one.id}${one.function ? `, ${one.function}` : ""}`,
      `${one.share === null ? "–" : `${number(100 * one.share, 0)} %`}${one.voltage_v === null ? "" : `, ${number(one.voltage_v, 1)} V`}`])),
    ["power", number(row.alive ? row.power_w : null, 0, " W")], ["lasts", !row.alive || row.endurance_s === null ? "–" : clock(row.endurance_s)],
    ["north, east", row.p_ned ? `${number(row.p_ned[0], 1)}, ${number(row.p_ned[1], 1)} m` : "–"], ["height", number(row.height_m, 1, " m")],
    ["speed", number(row.speed_m_s, 2, " m/s")], ["heading", degrees(row.heading_rad === null ? null : (row.heading_rad + 2 * Math.PI) % (2 * Math.PI))],
    ["roll, pitch", `${degrees(row.roll_rad)}, ${degrees(row.pitch_rad)}`], ["to its target", number(row.target_m, 2, " m")],
    ["competition", row.v === null ? "does not compete" : `v ${number(row.v, 2)}${row.tau === null ? "" : `, τ ${number(row.tau, 2)}`}`],
    ["link", `${row.lost} frames lost${row.lost_share === null ? "" : `, ${number(100 * row.lost_share, 1)} % lately`}`],
    ["position's age", number(row.age_s, 1, " s")],
    ...(row.remote_id ? [/** @type {[string, string]} */ (["Remote ID", row.remote_id])] : []),
    ...(session?.vehicles ?? []).flatMap((one) => (one.sysid === sysid && one.plan_b ? [/** @type {[string, string]} */ (["plan B", planText(one.plan_b)])] : [])),
  ];
  const key = `${row.sysid} ${row.trouble.join("|")} ${row.note} ${facts.map(([name]) => name).join("|")}`;
  renew(at, key, () => [
    h("h3", {}, row.label),
    ...row.trouble.map((text) => h("p", { class: row.severity > 1 ? "bad" : "warn" }, text)),
    row.note ? h("p", { class: "soft" }, row.note) : "",
    h("dl", { class: "facts" }, ...facts.map(([name]) => h("div", {}, h("dt", {}, name), h("dd")))),
  ]);
  at.querySelectorAll("dd").forEach((dd, k) => say(dd, facts[k][1]));
}
