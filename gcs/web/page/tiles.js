// Tiles of a web map (Web Mercator) under the fleet's map, from the server that a user named.
// @ts-check

/** @typedef {(metres: number) => number} Axis */

const TILE = 256;
const MOST_DRAWN = 80;
const MOST_KEPT = 400;
const DEEPEST = 19;
const POLE_DEG = 85;
const DEGREE = Math.PI / 180;
const EQUATOR_M = 6378137; // WGS 84
const ECCENTRICITY_2 = 0.00669438;

/** Metres of a degree north and east at a latitude, WGS 84. @param {number} lat @returns {[number, number]} */
export function degree(lat) {
  const w = 1 - ECCENTRICITY_2 * Math.sin(lat * DEGREE) ** 2;
  return [(DEGREE * EQUATOR_M * (1 - ECCENTRICITY_2)) / w ** 1.5, (DEGREE * EQUATOR_M * Math.cos(lat * DEGREE)) / Math.sqrt(w)];
}

/** Column of a longitude, and row of a latitude, in a world of `count` tiles each way. @param {number} lon @param {number} count */
export const column = (lon, count) => ((lon + 180) / 360) * count;
/** @param {number} lat @param {number} count */
export const row = (lat, count) => ((1 - Math.asinh(Math.tan(lat * DEGREE)) / Math.PI) / 2) * count;
/** @param {number} at @param {number} count */
const latitude = (at, count) => Math.atan(Math.sinh(Math.PI * (1 - (2 * at) / count))) / DEGREE;

export class Tiles {
  /** @param {string} template @param {() => void} arrived a tile has come, and the map is to be drawn again */
  constructor(template, arrived) {
    this.template = template;
    this.arrived = arrived;
    /** @type {Map<string, HTMLImageElement>} */
    this.kept = new Map();
    const host = new URL(template.replace(/[{}]/g, "")).hostname;
    this.credit = /(^|\.)openstreetmap\.org$/.test(host) ? "© OpenStreetMap contributors" : `map: ${host}`;
  }

  /**
   * @param {CanvasRenderingContext2D} context @param {readonly [number, number, number]} origin
   * @param {{n: number, e: number, perMetre: number, width: number, height: number}} frame @param {Axis} X @param {Axis} Y
   * @param {{paper: string, ink: string}} colours of the credit
   */
  draw(context, origin, frame, X, Y, colours) {
    const [lat0, lon0] = origin;
    if (Math.abs(lat0) > POLE_DEG) return;
    const [north_m, east_m] = degree(lat0);
    const zoom = Math.min(Math.max(Math.round(Math.log2((360 * east_m * frame.perMetre) / TILE)), 0), DEEPEST);
    const count = 2 ** zoom;
    const [high, wide] = [frame.height / 2 / frame.perMetre, frame.width / 2 / frame.perMetre];
    const [x0, x1] = [-wide, wide].map((by) => Math.floor(column(lon0 + (frame.e + by) / east_m, count)));
    const [y0, y1] = [high, -high].map((by) => Math.min(Math.max(Math.floor(row(lat0 + (frame.n + by) / north_m, count)), 0), count - 1));
    if ((x1 - x0 + 1) * (y1 - y0 + 1) > MOST_DRAWN) return;
    for (let y = y0; y <= y1; y += 1) {
      const [top, foot] = [y, y + 1].map((at) => Y((latitude(at, count) - lat0) * north_m));
      for (let x = x0; x <= x1; x += 1) {
        const image = this.#image(zoom, ((x % count) + count) % count, y);
        if (!image.complete || !image.naturalWidth) continue;
        const [left, right] = [x, x + 1].map((at) => X(((360 * at) / count - 180 - lon0) * east_m));
        context.drawImage(image, left, top, right - left, foot - top);
      }
    }
    context.font = "11px system-ui, sans-serif";
    context.lineWidth = 3;
    context.strokeStyle = colours.paper;
    context.strokeText(this.credit, 5, 14);
    context.fillStyle = colours.ink;
    context.fillText(this.credit, 5, 14);
  }

  /** @param {number} z @param {number} x @param {number} y */
  #image(z, x, y) {
    const url = this.template.replace("{z}", String(z)).replace("{x}", String(x)).replace("{y}", String(y));
    let image = this.kept.get(url);
    if (image) return image;
    image = new Image();
    image.referrerPolicy = "origin"; // servers of tiles ask for the origin; the link's token is never in it
    image.onload = this.arrived;
    image.src = url;
    if (this.kept.size >= MOST_KEPT) this.kept.delete(this.kept.keys().next().value ?? "");
    this.kept.set(url, image);
    return image;
  }
}
