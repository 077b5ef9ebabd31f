// An operator's commands: the same as in the console, each confirmed, answered, and shown to all as an event.
// @ts-check
import { h, say, vehicles } from "./elements.js";
import { modeOf } from "./signs.js";

/** @typedef {{key: string, command: string, name: string, what: string, question: string, of_vehicle: boolean, of_many: boolean, in_monitor: boolean, means: string}} Order */
/** @typedef {import("./messages").SnapshotMessage} Snapshot */
/** @typedef {import("./messages").VehicleRow} VehicleRow */
/** @typedef {import("./messages").PlanBRow} PlanB */

export class Operator {
  /**
   * @param {Order[]} orders
   * @param {(command: Record<string, unknown>, answer: (ok: boolean, text: string) => void) => boolean} send whether it was sent
   */
  constructor(orders, send) {
    this.orders = orders;
    this.send = send;
    /** whether the other end is a monitor, which has no planner and refuels nothing */
    this.monitors = false;
    this.notices = h("div", { class: "notices", role: "status", "aria-live": "polite" });
    this.dialog = h("dialog", { class: "ask", "aria-labelledby": "ask-question" });
    document.body.append(this.notices, this.dialog);
  }

  /** Whether the other end takes an order. @param {Order} order */
  takes(order) {
    return order.in_monitor || !this.monitors;
  }

  /** @param {Order} order */
  #means(order) {
    return this.monitors ? "" : order.means;
  }

  /** @param {string} text @param {"" | "good" | "bad"} [level] */
  notice(text, level = "") {
    const told = h("p", { class: level }, text);
    this.notices.append(told);
    while (this.notices.children.length > 4) this.notices.firstChild?.remove();
    setTimeout(() => told.remove(), level === "bad" ? 12000 : 6000);
  }

  /**
   * Ask once about several vehicles; send to those that can obey, and say how many did and which refused, and why.
   * @param {Order} order @param {number[]} sysids @param {boolean} all @param {(sysid: number) => string} name @param {() => Snapshot | null} present
   * @param {Map<number, PlanB | undefined>} plans plan B of each
   */
  askMany(order, sysids, all, name, present, plans) {
    if (this.dialog.open) return;
    const rows = (present()?.vehicles ?? []).filter((row) => sysids.includes(row.sysid));
    const able = rows.filter((row) => !refusal(row)).map((row) => row.sysid);
    const title = `${order.name[0].toUpperCase()}${order.name.slice(1)} ${all ? "all " : ""}${vehicles(rows.length)}?`;
    const which = all ? "" : sysids.join(", ");
    const yes = h("button", { type: "submit", value: "yes", class: "primary" }, "Yes");
    yes.disabled = !able.length;
    this.dialog.replaceChildren(h("form", { method: "dialog" }, h("h2", { id: "ask-question" }, title), which ? h("p", {}, which) : null, this.#means(order) ? h("p", { class: "soft" }, this.#means(order)) : null,
      ...listed(rows, refusal, (count) => `${count} of them cannot:`, "bad", name), ...listed(rows, doubt, (count) => `${count} ${count === 1 ? "takes" : "take"} the order, but:`, "warn", name),
      ...planned(rows, plans), h("p", { class: "buttons" }, yes, h("button", { type: "submit", value: "no" }, "No"))));
    this.dialog.returnValue = "no";
    this.dialog.onclose = () => {
      if (this.dialog.returnValue !== "yes") return;
      /** @type {string[]} */
      const refused = [];
      let waiting = able.length;
      const sent = able.filter((sysid) =>
        this.send({ command: order.command, sysid }, (ok, text) => {
          if (!ok) refused.push(text || `${name(sysid)}: not taken`);
          waiting -= 1;
          if (waiting) return;
          const obey = `${order.name}: ${able.length - refused.length} of ${able.length} obey.`;
          this.notice([obey, ...refused].join(" "), refused.length ? "bad" : "good");
        }));
      if (sent.length) this.notice(`${order.name} ${vehicles(sent.length)}: sent`);
    };
    this.dialog.showModal();
    /** @type {HTMLElement | null} */ (able.length ? yes : this.dialog.querySelector("button[value=no]"))?.focus();
  }

  /**
   * Ask, and send where the answer is yes.
   * @param {Order} order @param {number | null} sysid @param {(sysid: number) => string} name @param {() => Snapshot | null} present
   */
  ask(order, sysid, name, present) {
    if (this.dialog.open) return;
    if (order.of_vehicle && sysid === null) return void this.notice("No vehicle is chosen: choose one in the table, on the map or by its id.", "bad");
    const resume = order.command === "pause" && present()?.phase === "paused";
    const question = resume ? "Go on with the session?" : order.question.replace("{}", sysid === null ? "" : name(sysid));
    const row = () => present()?.vehicles.find((one) => one.sysid === sysid);
    const detail = h("p", { class: "soft" });
    const now = () => {
      const found = order.of_vehicle ? row() : undefined;
      say(detail, [found ? state(found) : "", this.#means(order)].filter(Boolean).join(". "));
    };
    const targets = order.command === "retarget" ? (present()?.vehicles ?? []).filter((one) => one.role === "target") : [];
    if (order.command === "retarget" && !targets.length) return void this.notice("There is no target.", "bad");
    const select = h("select", { "aria-label": "target" }, ...targets.map((one) => h("option", { value: one.sysid }, one.label)));
    const yes = h("button", { type: "submit", value: "yes", class: "primary" }, "Yes");
    const form = h("form", { method: "dialog" },
      h("h2", { id: "ask-question" }, question), detail, targets.length ? h("p", {}, select) : null,
      h("p", { class: "buttons" }, yes, h("button", { type: "submit", value: "no" }, "No")));
    this.dialog.replaceChildren(form);
    this.dialog.returnValue = "no";
    this.dialog.onclose = () => {
      clearInterval(keeping);
      if (this.dialog.returnValue !== "yes") return;
      /** @type {Record<string, unknown>} */
      const command = { command: resume ? "resume" : order.command };
      if (order.of_vehicle) command.sysid = sysid;
      if (targets.length) command.target = Number(select.value);
      const what = order.of_vehicle && sysid !== null ? `${order.name} ${name(sysid)}` : resume ? "resume" : order.name;
      const sent = this.send(command, (ok, text) => this.notice(`${what}: ${text || (ok ? "taken" : "not taken")}`, ok ? "good" : "bad"));
      if (sent) this.notice(`${what}: sent`);
    };
    now();
    const keeping = setInterval(now, 500);
    this.dialog.showModal();
    yes.focus();
  }
}

/** Why no order reaches a vehicle; empty where one does. The session has the last word. @param {VehicleRow} row */
function refusal(row) {
  return !row.alive ? "is dead." : row.heard_s === null ? "has not sent any telemetry yet." : "";
}

/** Why an order that is taken may change nothing; empty where it should. @param {VehicleRow} row */
function doubt(row) {
  if (refusal(row)) return "";
  if (row.condition === "silent") return `is silent (${row.figure}) and may not hear it.`;
  if (!row.armed) return "is on the ground and stays there.";
  if (row.landed) return "has landed and stays there.";
  if (row.note.startsWith("taken by")) return `is ${row.note} already (${row.mode_name}).`;
  if (row.trouble.includes(`failsafe: ${row.mode_name}`)) return `is in ${row.mode_name} by its own failsafe, which the order would end.`;
  if (row.condition === "failing" && row.trouble.includes(row.mode_name)) return `is in ${row.mode_name} without an order from here, which this order would end.`;
  return "";
}

/**
 * Vehicles for which there is a reason, a sentence each.
 * @param {VehicleRow[]} rows @param {(row: VehicleRow) => string} reason @param {(count: number) => string} head @param {string} level @param {(sysid: number) => string} name
 */
function listed(rows, reason, head, level, name) {
  const texts = rows.flatMap((row) => (reason(row) ? [`${name(row.sysid)} ${reason(row)}`] : []));
  return texts.length ? [h("p", { class: level }, head(texts.length)), h("ul", { class: `${level} refusing`, tabindex: 0 }, ...texts.map((text) => h("li", {}, text)))] : [];
}

/** Plan B in words. @param {PlanB | undefined} plan */
export function planText(plan) {
  if (!plan) return "by its own parameters";
  const times = plan.down_after_s ? `, level from ${plan.level_after_s.toFixed(0)} s, down from ${plan.down_after_s.toFixed(0)} s after the last HEARTBEAT` : "";
  return `straight home at ${plan.return_m.toFixed(1)} m above it${times}`;
}

/** How the vehicles come home by themselves, those alike in one line. @param {VehicleRow[]} rows @param {Map<number, PlanB | undefined>} plans */
function planned(rows, plans) {
  /** @type {Map<string, number[]>} */
  const alike = new Map();
  for (const { sysid } of rows) {
    const text = planText(plans.get(sysid));
    alike.set(text, [...(alike.get(text) ?? []), sysid]);
  }
  const lines = [...alike].map(([text, sysids]) => h("tr", {}, h("th", { scope: "row" }, sysids.join(", ")), h("td", { class: "word" }, text)));
  if (!lines.length) return [];
  return [h("div", { class: "scroll plan-b", tabindex: 0, role: "region", "aria-label": "plan B" },
    h("table", {}, h("caption", {}, "Plan B, how each comes home by itself"), h("tbody", {}, ...lines)))];
}

/** What an operator should have in view while deciding. @param {VehicleRow} row */
function state(row) {
  const battery = row.battery === null ? "" : `, battery ${(100 * row.battery).toFixed(0)} %`;
  const height = row.height_m === null ? "" : `, ${row.height_m.toFixed(1)} m high`;
  return `${modeOf(row) || row.state || "mode not known"}${height}${battery}`;
}
