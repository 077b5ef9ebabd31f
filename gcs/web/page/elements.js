// Small helpers to build elements. Text is always set as text: what a vehicle or a scenario says is never markup.
// @ts-check

/**
 * @template {keyof HTMLElementTagNameMap} T
 * @param {T} tag
 * @param {Record<string, any>} [attributes] `class`, `on…` listeners, and attributes; false and null are left out
 * @param {...(Node | string | null | false)} children
 * @returns {HTMLElementTagNameMap[T]}
 */
export function h(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === false || value === null || value === undefined) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (name === "class") element.className = value;
    else element.setAttribute(name, value === true ? "" : String(value));
  }
  for (const child of children) if (child !== null && child !== false) element.append(child);
  return element;
}

/** The key that does what a button does, written on it. @param {string} name */
export const key = (name) => h("kbd", { "aria-hidden": "true" }, name);

/** Set an element's text where it differs: an unchanged node costs no layout. @param {Node} element @param {string} text */
export function say(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

/** @param {number | null | undefined} value @param {number} digits @param {string} [unit] */
export function number(value, digits, unit = "") {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const text = value.toFixed(digits);
  return `${Number(text) === 0 ? text.replace("-", "") : text.replace("-", "−")}${unit}`;
}

/** `1 vehicle`, `2 vehicles`. @param {number} count */
export const vehicles = (count) => `${count} ${count === 1 ? "vehicle" : "vehicles"}`;

/** Seconds as minutes and seconds. @param {number} t_s */
export function clock(t_s) {
  const sign = t_s < 0 ? "−" : "";
  const whole = Math.abs(t_s);
  const minutes = Math.floor(whole / 60);
  return `${sign}${minutes}:${(whole - 60 * minutes).toFixed(1).padStart(4, "0")}`;
}

/**
 * A canvas that has its box's size in device pixels.
 * @param {HTMLCanvasElement} canvas @returns {{width: number, height: number, scale: number, changed: boolean}}
 */
export function fit(canvas) {
  const box = canvas.getBoundingClientRect();
  const scale = Math.min(window.devicePixelRatio || 1, 2);
  const width = Math.max(Math.round(box.width * scale), 1);
  const height = Math.max(Math.round(box.height * scale), 1);
  const changed = canvas.width !== width || canvas.height !== height;
  if (changed) {
    canvas.width = width;
    canvas.height = height;
  }
  return { width: box.width, height: box.height, scale, changed };
}
