// The line of time: a slider over what is known, marks of events, play, pause and speed.
// @ts-check
import { clock, fit, h, say } from "./elements.js";
import { plane } from "./graphics.js";
import { look } from "./look.js";

/** @typedef {import("./messages").EventRow} EventRow */
/**
 * What the line of time moves: the page's own time, or a replay on the server.
 * @typedef {{seek: (t_s: number) => void, toggle: () => void, faster: (step: number) => void, newest: (() => void) | null}} Player
 */

const SHOWN_MS = 100;

/** The moment that the page's address names (`#t=33`), s; null without. */
export function linkedTime() {
  const t_s = Number.parseFloat(new URLSearchParams(location.hash.slice(1)).get("t") ?? "");
  return Number.isFinite(t_s) ? t_s : null;
}

export class Timeline {
  /** @param {HTMLElement} parent @param {Player} player */
  constructor(parent, player) {
    this.player = player;
    this.marks = h("canvas", { class: "marks", "aria-hidden": "true" });
    this.slider = h("input", { type: "range", min: 0, max: 1, step: 0.1, value: 0, "aria-label": "time",
      oninput: () => { this.dragged_at = performance.now(); player.seek(Number(this.slider.value)); } });
    this.dragged_at = -Infinity;
    this.play = h("button", { type: "button", onclick: () => player.toggle() }, "pause");
    this.slower = h("button", { type: "button", "aria-label": "slower", onclick: () => player.faster(-1) }, "−");
    this.quicker = h("button", { type: "button", "aria-label": "faster", onclick: () => player.faster(1) }, "+");
    this.speed = h("span", { class: "value" });
    this.time = h("span", { class: "value time" });
    this.live = h("button", { type: "button", class: "live", onclick: () => player.newest?.() }, "live");
    this.live.hidden = !player.newest;
    this.marked = "";
    parent.append(h("div", { class: "tools" }, this.play, this.slower, this.speed, this.quicker, this.time, this.live), h("div", { class: "line" }, this.marks, this.slider));
  }

  /**
   * @param {{now_s: number, begin_s: number, end_s: number, playing: boolean, speed: string, following: boolean, events: EventRow[]}} state
   */
  show({ now_s, begin_s, end_s, playing, speed, following, events }) {
    say(this.play, playing ? "pause" : "play");
    say(this.speed, speed);
    say(this.time, `${clock(now_s)} of ${clock(end_s)}`);
    this.live.setAttribute("aria-pressed", String(following));
    const [min, max] = [begin_s.toFixed(1), Math.max(end_s, begin_s + 0.1).toFixed(1)];
    if (this.slider.min !== min) this.slider.min = min;
    if (this.slider.max !== max) this.slider.max = max;
    if (performance.now() - this.dragged_at > 4 * SHOWN_MS) this.slider.value = now_s.toFixed(1);
    this.slider.setAttribute("aria-valuetext", clock(now_s));
    const box = this.marks.clientWidth;
    const key = `${box} ${events.length} ${min} ${max} ${look().dark}`;
    if (key === this.marked) return;
    this.marked = key;
    const { width, height, scale } = fit(this.marks);
    const context = plane(this.marks);
    const { bad, warn, soft } = look();
    context.setTransform(scale, 0, 0, scale, 0, 0);
    context.clearRect(0, 0, width, height);
    const span_s = Math.max(end_s - begin_s, 0.1);
    for (const level of ["info", "warning", "critical"]) {
      context.fillStyle = level === "info" ? soft : level === "warning" ? warn : bad;
      const high = level === "info" ? 0.4 : level === "warning" ? 0.7 : 1;
      for (const event of events) {
        if (event.level !== level || event.t_s < begin_s || event.t_s > end_s) continue;
        context.fillRect(((event.t_s - begin_s) / span_s) * width - 0.75, height * (1 - high), 1.5, height * high);
      }
    }
  }
}
