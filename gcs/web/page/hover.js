// What a vehicle is and does, beside the pointer that rests on it in map or space.
// @ts-check
import { nearest } from "./box.js";
import { h, number, say } from "./elements.js";
import { modeOf } from "./signs.js";

/** @typedef {import("./messages").VehicleRow} VehicleRow */

/** `pursuer 5 · Offboard · battery 43 % · 5.0 m high · 1.2 m/s`. @param {VehicleRow} row */
export function described(row) {
  const parts = [
    row.label, row.trouble.join(", "), modeOf(row), row.battery === null ? "" : `battery ${number(100 * row.battery, 0)} %`,
    row.height_m === null ? "" : `${number(row.height_m, 1)} m high`, row.speed_m_s === null ? "" : `${number(row.speed_m_s, 1)} m/s`,
  ];
  return parts.filter(Boolean).join(" · ");
}

export class Hover {
  /** @param {HTMLElement} picture @param {() => {places: import("./box.js").Place[], rows: VehicleRow[]}} shown */
  constructor(picture, shown) {
    this.shown = shown;
    this.element = h("div", { class: "hover small", "aria-hidden": "true" }); // the table has the same, and more
    this.element.hidden = true;
    /** @type {number[] | null} */
    this.at = null;
    picture.append(this.element);
    picture.addEventListener("pointermove", (event) => {
      const { left, top } = picture.getBoundingClientRect();
      this.at = event.buttons || event.pointerType === "touch" ? null : [event.clientX - left, event.clientY - top];
      this.show();
    });
    picture.addEventListener("pointerleave", () => {
      this.at = null;
      this.show();
    });
  }

  /** Again after each frame: vehicles move under a pointer that rests. */
  show() {
    const { at } = this;
    const { places, rows } = at ? this.shown() : { places: [], rows: [] };
    const sysid = at && nearest(places, at[0], at[1]);
    const row = rows.find((one) => one.sysid === sysid);
    if (this.element.hidden !== !row) this.element.hidden = !row;
    const place = places.find((one) => one.sysid === sysid);
    if (!row || !place) return;
    say(this.element, described(row));
    const left = place.x > (this.element.parentElement?.clientWidth ?? 0) / 2;
    this.element.style.transform = `translate(${place.x + (left ? -14 : 14)}px, ${place.y + 10}px) translateX(${left ? "-100%" : "0"})`;
  }
}
