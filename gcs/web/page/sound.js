// A sound where a vehicle's condition gets worse, once it has been switched on: the worse, the more tones.
// @ts-check
import { h } from "./elements.js";
import { rank } from "./strip.js";

/** @typedef {import("./messages").SnapshotMessage} Snapshot */

const PAUSE_MS = 800;
const TONE_S = 0.14;
/** Hz, by condition; those that are not here make no sound. @type {Record<string, number[]>} */
const TONES = { dead: [880, 660, 880], silent: [880, 660], failing: [880, 660], low: [520] };

export class Sound {
  constructor() {
    this.button = h("button", { type: "button", "aria-pressed": "false", title: "a sound where a vehicle dies, falls silent, fails or runs low", onclick: () => this.toggle() }, "sound");
    /** @type {AudioContext | null} */
    this.audio = null;
    /** how often it has sounded */
    this.rung = 0;
    this.at = -Infinity;
    /** the rank of each vehicle's condition when it was last looked at @type {Map<number, number>} */
    this.known = new Map();
  }

  toggle() {
    if (this.audio) {
      void this.audio.close();
      this.audio = null;
    } else {
      this.audio = new AudioContext();
      this.#ring(TONES.low); // so that its loudness can be set
    }
    this.button.setAttribute("aria-pressed", String(this.audio !== null));
  }

  /** @param {Snapshot} snapshot */
  watch(snapshot) {
    const worse = snapshot.vehicles.filter((row) => rank(row) < (this.known.get(row.sysid) ?? Infinity) && TONES[row.condition]).sort((a, b) => rank(a) - rank(b))[0];
    this.known = new Map(snapshot.vehicles.map((row) => [row.sysid, rank(row)]));
    if (!worse || !this.audio || performance.now() - this.at < PAUSE_MS) return;
    this.at = performance.now();
    this.rung += 1;
    this.#ring(TONES[worse.condition]);
  }

  /** @param {number[]} tones */
  #ring(tones) {
    const audio = /** @type {AudioContext} */ (this.audio);
    tones.forEach((pitch, k) => {
      const [tone, loud] = [audio.createOscillator(), audio.createGain()];
      const from = audio.currentTime + k * TONE_S;
      tone.frequency.value = pitch;
      loud.gain.setValueAtTime(0.25, from);
      loud.gain.exponentialRampToValueAtTime(0.001, from + TONE_S);
      tone.connect(loud).connect(audio.destination);
      tone.start(from);
      tone.stop(from + TONE_S);
    });
  }
}
