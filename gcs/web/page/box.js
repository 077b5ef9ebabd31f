// A box drawn over the picture selects the vehicles in it: with Shift held, or once the button `box` is pressed.
// @ts-check
import { h } from "./elements.js";

/** @typedef {{sysid: number, x: number, y: number}} Place where a vehicle is drawn, in CSS pixels of its picture */

const DRAGGED = 4; // pixels: what moves less is a click
const REACH = 24; // of a click

/** The vehicle that a click means. @param {Place[]} places @param {number} x @param {number} y @returns {number | null} */
export function nearest(places, x, y) {
  const [first] = places.map((one) => ({ sysid: one.sysid, off: Math.hypot(one.x - x, one.y - y) })).sort((a, b) => a.off - b.off);
  return first && first.off < REACH ? first.sysid : null;
}

/** Vehicles between two corners. @param {Place[]} places @param {number[]} a @param {number[]} b */
export function within(places, a, b) {
  const [[x0, x1], [y0, y1]] = [0, 1].map((k) => [a[k], b[k]].sort((u, w) => u - w));
  return places.filter((one) => one.x >= x0 && one.x <= x1 && one.y >= y0 && one.y <= y1).map((one) => one.sysid);
}

export class Box {
  /**
   * @param {HTMLElement} picture
   * @param {{places: () => Place[], take: (sysids: number[], add: boolean) => void, pick: (sysid: number | null, event: MouseEvent) => void}} options
   *   `add`: to what is selected already
   */
  constructor(picture, { places, take, pick }) {
    this.button = h("button", { type: "button", "aria-pressed": "false", title: "select the vehicles in a box: drag it over the picture (or drag with Shift held); b selects all that are in the picture",
      onclick: () => this.arm(!this.armed) }, "box");
    this.armed = false;
    const frame = h("div", { class: "box" });
    frame.hidden = true;
    picture.append(frame);
    /** @type {{id: number, from: number[]} | null} */
    let held = null;
    const at = (/** @type {PointerEvent} */ event) => {
      const { left, top, width, height } = picture.getBoundingClientRect();
      return [Math.min(Math.max(event.clientX - left, 0), width), Math.min(Math.max(event.clientY - top, 0), height)];
    };
    const far = (/** @type {number[]} */ a, /** @type {number[]} */ b) => Math.hypot(a[0] - b[0], a[1] - b[1]) > DRAGGED;
    // In the first phase, so that neither map nor space is moved by the same drag.
    picture.addEventListener("pointerdown", (event) => {
      if (held || event.button !== 0 || !(event.shiftKey || this.armed)) return;
      event.stopPropagation();
      held = { id: event.pointerId, from: at(event) };
      picture.setPointerCapture(event.pointerId);
    }, { capture: true });
    picture.addEventListener("pointermove", (event) => {
      if (event.pointerId !== held?.id) return;
      event.stopPropagation();
      const to = at(event);
      frame.hidden = !far(held.from, to);
      const [x, y] = [0, 1].map((k) => Math.min(/** @type {any} */ (held).from[k], to[k]));
      Object.assign(frame.style, { left: `${x}px`, top: `${y}px`, width: `${Math.abs(to[0] - held.from[0])}px`, height: `${Math.abs(to[1] - held.from[1])}px` });
    }, { capture: true });
    const release = (/** @type {PointerEvent} */ event) => {
      if (event.pointerId !== held?.id) return;
      event.stopPropagation();
      const [from, to] = [held.from, at(event)];
      held = null;
      frame.hidden = true;
      if (event.type !== "pointerup") return;
      if (far(from, to)) take(within(places(), from, to), event.shiftKey);
      else pick(nearest(places(), to[0], to[1]), event);
      this.arm(false);
    };
    picture.addEventListener("pointerup", release, { capture: true });
    picture.addEventListener("pointercancel", release, { capture: true });
  }

  /** Whether the next drag draws a box. @param {boolean} on */
  arm(on) {
    this.armed = on;
    this.button.setAttribute("aria-pressed", String(on));
  }
}
