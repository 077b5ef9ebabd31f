// Five steps through the page on the first visit; it covers nothing up, and can be left at any step.
// @ts-check
import { h, say } from "./elements.js";

const SEEN = "skytender-tour";

/** Where each step points, and what it says. @type {[string, string][]} */
export const STEPS = [
  [".strip", "Trouble stands here: how many vehicles are dead, silent, failing, low or warned, and how badly. A click selects them."],
  [".picture", "The fleet, in space (key 3) or on a map (key M). Drag to move, click a vehicle to select it, drag with Shift held to select all in a box."],
  [".fleet-scroll", "Every vehicle, those in trouble first. Shift or Ctrl adds to the selection; orders then go to all selected vehicles."],
  [".top", "Orders ask first, and list which vehicles cannot obey. Keys stand on their buttons; the key ? lists them all."],
  [".time-line", "The line of time: go back while the flight goes on, and return with “live”. Marks are events."],
];

export class Tour {
  constructor() {
    this.step = -1;
    this.text = h("p", { "aria-live": "polite" });
    this.count = h("b", { class: "small soft" });
    this.next = h("button", { type: "button", class: "primary", onclick: () => this.go(this.step + 1) }, "Next");
    this.element = h("section", { class: "tour", "aria-label": "tour" }, this.count, this.text,
      h("div", { class: "tools" }, this.next, h("button", { type: "button", onclick: () => this.end() }, "Close tour")));
    this.element.hidden = true;
    document.body.append(this.element);
  }

  /** Begin where this browser has not seen it. */
  first() {
    try {
      if (localStorage.getItem(SEEN)) return;
    } catch {
      return; // what keeps nothing would show it each time
    }
    this.go(0);
  }

  /** @param {number} step */
  go(step) {
    if (step >= STEPS.length) return this.end();
    this.#point(step);
    this.element.hidden = false;
    say(this.count, `${step + 1} of ${STEPS.length}`);
    say(this.text, STEPS[step][1]);
    say(this.next, step + 1 < STEPS.length ? "Next" : "Done");
  }

  end() {
    this.#point(-1);
    this.element.hidden = true;
    try {
      localStorage.setItem(SEEN, "seen");
    } catch {
      // as above
    }
  }

  /** @param {number} step */
  #point(step) {
    document.querySelector(".pointed")?.classList.remove("pointed");
    this.step = step;
    if (step >= 0) document.querySelector(STEPS[step][0])?.classList.add("pointed");
  }
}
