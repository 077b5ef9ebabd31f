// A session, a monitor or a replay on the server that gave this page: messages in, commands out, over one WebSocket.
// @ts-check

/** What a source sends, and where the server has the report of its session. @typedef {import("./messages").Line | {type: "report", path: string}} Line */
/** @typedef {import("./messages").EventRow} EventRow */
/** @typedef {"connecting" | "open" | "lost" | "refused" | "ended"} State */

const RETRY_S = [0.25, 0.5, 1, 2, 4];
export const NO_TOKEN = 4401;
const PROTOCOL = "skytender";

export class Live {
  /**
   * @param {(line: Line) => void} take
   * @param {(state: State) => void} changed
   * @param {() => void} restart another session speaks in the same place
   */
  constructor(take, changed, restart) {
    this.restart = restart;
    this.take = take;
    this.changed = changed;
    /** @type {State} */
    this.state = "connecting";
    this.heard = 0;
    this.heard_ms = performance.now();
    this.sent = 0;
    this.tries = 0;
    /** @type {WebSocket | null} */
    this.socket = null;
    /** @type {Map<string, (ok: boolean, text: string) => void>} */
    this.waiting = new Map();
    this.token = new URLSearchParams(location.hash.slice(1)).get("token") ?? "";
  }

  open() {
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const socket = new WebSocket(`${scheme}://${location.host}/stream`, [PROTOCOL, `token.${this.token || "none"}`]);
    this.socket = socket;
    socket.onopen = () => {
      this.tries = 0;
      this.#become("open");
    };
    socket.onmessage = (message) => {
      const told = JSON.parse(message.data);
      for (const line of Array.isArray(told) ? told : [told]) this.#hear(line); // the past comes as one
    };
    socket.onclose = (event) => {
      if (this.state === "ended") return;
      this.#giveUpWaiting();
      if (event.code === NO_TOKEN) return void this.#become("refused");
      this.#become("lost");
      setTimeout(() => this.open(), 1e3 * RETRY_S[Math.min(this.tries, RETRY_S.length - 1)]);
      this.tries += 1;
    };
  }

  /** @param {Line} line */
  #hear(line) {
    this.heard_ms = performance.now();
    if (line.type === "reply") {
      const answer = this.waiting.get(String(line.id));
      this.waiting.delete(String(line.id));
      answer?.(line.ok, line.text);
      return;
    }
    if (line.type === "session" && line.events !== undefined) {
      const told = line.told ?? 0;
      const again = told < this.heard; // another session, in the same place
      const missed = Math.min(told - (again ? 0 : this.heard), line.events.length);
      this.heard = told;
      if (again) this.restart();
      line = { ...line, events: line.events.slice(line.events.length - missed) };
    } else if (line.type === "snapshot") {
      this.heard += line.events.length;
    } else if (line.type === "end") {
      this.#become("ended");
    }
    this.take(line);
  }

  /** For how long nothing has come. */
  get silent_s() {
    return 1e-3 * (performance.now() - this.heard_ms);
  }

  /** Whether it was sent; else that is the answer. @param {Record<string, unknown>} command @param {(ok: boolean, text: string) => void} [answer] */
  send(command, answer) {
    if (this.state !== "open" || !this.socket) {
      answer?.(false, `${this.state === "ended" ? "The session has ended" : "There is no connection"}: it was not sent.`);
      return false;
    }
    this.sent += 1;
    const id = `page-${this.sent}`;
    if (answer) this.waiting.set(id, answer);
    this.socket.send(JSON.stringify({ ...command, id }));
    return true;
  }

  /** @param {State} state */
  #become(state) {
    this.state = state;
    this.changed(state);
  }

  #giveUpWaiting() {
    for (const answer of this.waiting.values()) answer(false, "The connection was lost before an answer came.");
    this.waiting.clear();
  }
}
