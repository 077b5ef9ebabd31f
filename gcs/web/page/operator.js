// An operator's commands: the same as in the console, each confirmed, answered, and shown to all as an event.
// @ts-check
import { h, say } from "./elements.js";

/** @typedef {{key: string, command: string, name: string, what: string, question: string, of_vehicle: boolean, of_many: boolean, means: string}} Order */
/** @typedef {import("./messages").SnapshotMessage} Snapshot */

export class Operator {
  /**
   * @param {Order[]} orders
   * @param {(command: Record<string, unknown>, answer: (ok: boolean, text: string) => void) => void} send
   */
  constructor(orders, send) {
    this.orders = orders;
    this.send = send;
    this.notices = h("div", { class: "notices", role: "status", "aria-live": "polite" });
    this.dialog = h("dialog", { class: "ask", "aria-labelledby": "ask-question" });
    document.body.append(this.notices, this.dialog);
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
   */
  askMany(order, sysids, all, name, present) {
    if (this.dialog.open) return;
    const rows = (present()?.vehicles ?? []).filter((row) => sysids.includes(row.sysid));
    const refusing = rows.flatMap((row) => (refusal(row) ? [`${name(row.sysid)} ${refusal(row)}`] : []));
    const able = rows.filter((row) => !refusal(row)).map((row) => row.sysid);
    const title = `${order.name[0].toUpperCase()}${order.name.slice(1)} ${all ? "all " : ""}${rows.length} vehicles?`;
    const list = h("ul", { class: "refusing" }, ...refusing.map((text) => h("li", {}, text)));
    const which = all ? "" : sysids.join(", ");
    const yes = h("button", { type: "submit", value: "yes", class: "primary" }, "Yes");
    yes.disabled = !able.length;
    this.dialog.replaceChildren(h("form", { method: "dialog" }, h("h2", { id: "ask-question" }, title), which ? h("p", {}, which) : null, order.means ? h("p", { class: "soft" }, order.means) : null,
      refusing.length ? h("p", { class: "bad" }, `${refusing.length} of them cannot:`) : null, refusing.length ? list : null,
      h("p", { class: "buttons" }, yes, h("button", { type: "submit", value: "no" }, "No"))));
    this.dialog.returnValue = "no";
    this.dialog.onclose = () => {
      if (this.dialog.returnValue !== "yes") return;
      /** @type {string[]} */
      const refused = [];
      let waiting = able.length;
      this.notice(`${order.name} ${able.length} vehicles: sent`);
      for (const sysid of able) {
        this.send({ command: order.command, sysid }, (ok, text) => {
          if (!ok) refused.push(text || `${name(sysid)}: not taken`);
          waiting -= 1;
          if (waiting) return;
          const obey = `${order.name}: ${able.length - refused.length} of ${able.length} obey.`;
          this.notice([obey, ...refused].join(" "), refused.length ? "bad" : "good");
        });
      }
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
      say(detail, [found ? state(found) : "", order.means].filter(Boolean).join(". "));
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
      this.notice(`${what}: sent`);
      this.send(command, (ok, text) => this.notice(`${what}: ${text || (ok ? "taken" : "not taken")}`, ok ? "good" : "bad"));
    };
    now();
    const keeping = setInterval(now, 500);
    this.dialog.showModal();
    yes.focus();
  }
}

/** Why no order reaches a vehicle; empty where one does. The session has the last word. @param {import("./messages").VehicleRow} row */
function refusal(row) {
  return !row.alive ? "is dead." : row.heard_s === null ? "has not sent any telemetry yet." : "";
}

/** What an operator should have in view while deciding. @param {import("./messages").VehicleRow} row */
function state(row) {
  const battery = row.battery === null ? "" : `, battery ${(100 * row.battery).toFixed(0)} %`;
  const height = row.height_m === null ? "" : `, ${row.height_m.toFixed(1)} m high`;
  return `${row.mode || row.state || "mode not known"}${height}${battery}`;
}
