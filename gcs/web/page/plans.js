// Missions, geofences and rally points: of the scenario, of vehicles in a recording, of files beside it.
// @ts-check
import { h, number } from "./elements.js";
import { colourOf, look } from "./look.js";

/** @typedef {import("./messages").PlanRow} PlanRow */
/** @typedef {import("./messages").PlanItemRow} PlanItemRow */
/** @typedef {import("./messages").SessionLine} SessionLine */
/** @typedef {import("./messages").SnapshotMessage} Snapshot */
/** @typedef {(metres: number) => number} Axis */

const NEAR_M = 1e5; // what lies farther off is not what the picture is fitted to
const MOST_NUMBERED = 300;

/** @param {SessionLine | null | undefined} session @returns {PlanRow[]} */
export const plansOf = (session) => session?.plans ?? [];

/** Everything of a plan that has a place, north and east. @param {SessionLine | null | undefined} session @returns {[number, number][]} */
export function covered(session) {
  const found = plansOf(session).flatMap((plan) => [
    ...plan.items.flatMap((item) => (item.p_ned ? [item.p_ned] : [])), ...plan.rally_ned, ...(plan.home_ned ? [plan.home_ned] : []), ...plan.fence.flatMap((area) => area.outline_ne),
  ]);
  return found.filter(([n, e]) => Math.hypot(n, e) < NEAR_M).map(([n, e]) => /** @type {[number, number]} */ ([n, e]));
}

/** @param {PlanRow} plan */
const inkOf = (plan) => (plan.sysid === null ? look().ink : colourOf(plan.sysid));

/** Where a vehicle that has a plan flies by it. @param {PlanRow} plan @returns {(PlanItemRow & {p_ned: [number, number, number]})[]} */
const flown = (plan) => /** @type {any} */ (plan.items.filter((item) => item.flown && item.p_ned));

/** The lines of all plans, as places in NED: a mission from its home, fences on the ground. @param {SessionLine | null | undefined} session */
export function lines(session) {
  return plansOf(session).flatMap((plan) => {
    const way = flown(plan).map((item) => item.p_ned);
    return [
      { points: plan.home_ned && way.length ? [plan.home_ned, ...way] : way, colour: inkOf(plan) },
      ...plan.fence.map((area) => ({ points: area.outline_ne.map(([n, e]) => /** @type {[number, number, number]} */ ([n, e, 0])), colour: area.inside ? look().good : look().bad })),
      ...plan.rally_ned.map(([n, e, d]) => ({ points: /** @type {[number, number, number][]} */ ([[n, e, 0], [n, e, d]]), colour: look().good })),
    ];
  });
}

/** @param {CanvasRenderingContext2D} context @param {SessionLine | null | undefined} session @param {Snapshot} snapshot @param {Axis} X @param {Axis} Y */
export function drawPlans(context, session, snapshot, X, Y) {
  const { good, bad, paper, ink } = look();
  context.save();
  context.font = "600 10px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  for (const plan of plansOf(session)) {
    for (const area of plan.fence) {
      context.strokeStyle = context.fillStyle = area.inside ? good : bad;
      context.lineWidth = 1.8;
      context.setLineDash([10, 4]);
      context.beginPath();
      area.outline_ne.forEach(([n, e], k) => context[k ? "lineTo" : "moveTo"](X(e), Y(n)));
      context.globalAlpha = area.inside ? 0.04 : 0.1;
      context.fill();
      context.globalAlpha = 0.9;
      context.stroke();
    }
    context.globalAlpha = 1;
    context.strokeStyle = inkOf(plan);
    context.lineWidth = 1.6;
    context.setLineDash([8, 5]);
    context.beginPath();
    const way = flown(plan);
    const [first] = way;
    if (plan.home_ned && first) context.moveTo(X(plan.home_ned[1]), Y(plan.home_ned[0]));
    way.forEach(({ p_ned: [n, e] }, k) => context[k || plan.home_ned ? "lineTo" : "moveTo"](X(e), Y(n)));
    context.stroke();
    context.setLineDash([]);
    const under_way = currentOf(plan, snapshot);
    for (const item of plan.items.slice(0, MOST_NUMBERED)) {
      if (!item.p_ned) continue;
      const [x, y] = [X(item.p_ned[1]), Y(item.p_ned[0])];
      context.beginPath();
      if (item.flown) context.arc(x, y, 8, 0, 2 * Math.PI);
      else context.rect(x - 7, y - 7, 14, 14);
      context.fillStyle = item.number === under_way ? inkOf(plan) : paper;
      context.fill();
      context.stroke();
      context.fillStyle = item.number === under_way ? paper : ink;
      context.fillText(String(item.number), x, y);
    }
    const marks = /** @type {[string, [number, number, number], string][]} */ (plan.rally_ned.map((at) => ["R", at, good]));
    if (plan.home_ned) marks.push(["H", plan.home_ned, inkOf(plan)]);
    for (const [letter, [n, e], colour] of marks) {
      context.beginPath();
      [[0, -10], [10, 0], [0, 10], [-10, 0]].forEach(([u, w], k) => context[k ? "lineTo" : "moveTo"](X(e) + u, Y(n) + w));
      context.closePath();
      context.fillStyle = paper;
      context.fill();
      context.strokeStyle = context.fillStyle = colour;
      context.stroke();
      context.fillText(letter, X(e), Y(n));
      context.strokeStyle = inkOf(plan);
    }
  }
  context.restore();
}

/** @param {PlanRow} plan @param {Snapshot} snapshot */
const currentOf = (plan, snapshot) => (plan.sysid === null ? undefined : snapshot.vehicles.find((row) => row.sysid === plan.sysid)?.mission_item);

/** @param {number} count @param {string} one @param {string} many */
const counted = (count, one, many) => (count ? [`${count} ${count === 1 ? one : many}`] : []);

/** The items of every plan as a table. @param {HTMLElement} at @param {SessionLine | null | undefined} session @param {Snapshot} snapshot */
export function showPlans(at, session, snapshot) {
  const plans = plansOf(session);
  const current = plans.map((plan) => currentOf(plan, snapshot));
  const key = JSON.stringify([plans, current]);
  if (at.dataset.key === key) return;
  at.dataset.key = key;
  const open = new Set([...at.querySelectorAll("details[open]")].map((one) => one.getAttribute("data-source")));
  at.replaceChildren(...plans.map((plan, k) => {
    const parts = [...counted(plan.items.length, "item", "items"), ...counted(plan.fence.length, "fence area", "fence areas"), ...counted(plan.rally_ned.length, "rally point", "rally points")];
    const rows = plan.items.map((item) => h("tr", { class: item.number === current[k] ? "chosen" : "", "aria-current": item.number === current[k] ? "step" : null },
      ...[String(item.number), item.command, item.height_m === null ? "" : `${number(item.height_m, 1)} m`, item.above === null ? "" : `above ${item.above}`,
        item.p_ned ? `${number(item.p_ned[0], 1)}, ${number(item.p_ned[1], 1)}` : "", item.about].map((text, column) => h("td", { class: [1, 3, 5].includes(column) ? "word" : "" }, text))));
    const heads = ["", "command", "height", "", "north, east m", "parameters"].map((name, column) => h(name ? "th" : "td", { scope: name ? "col" : null, class: [1, 3, 5].includes(column) ? "word" : "" }, name));
    const table = rows.length ? [h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": `mission of ${plan.source}` }, h("table", {}, h("thead", {}, h("tr", {}, ...heads)), h("tbody", {}, ...rows)))] : [];
    const details = h("details", { "data-source": plan.source }, h("summary", {}, h("b", {}, plan.source), `: ${parts.join(", ") || "nothing"}`), ...table, ...plan.left_out.map((text) => h("p", { class: "warn small" }, text)));
    details.open = at.childElementCount ? open.has(plan.source) : plans.length === 1;
    return details;
  }));
}
