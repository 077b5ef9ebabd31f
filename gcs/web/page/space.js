// The fleet in space: bodies with their attitudes, paths, rings, obstacles, traffic and transfers. x east, y up, z south.
// @ts-check
import {
  AmbientLight, ArrowHelper, BufferAttribute, BufferGeometry, Color, DirectionalLight, DoubleSide, Group, GridHelper, InstancedMesh,
  LineBasicMaterial, LineSegments, Matrix4, Mesh, MeshLambertMaterial, PerspectiveCamera, Quaternion, Scene, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { body } from "./bodies.js";
import { nearest } from "./box.js";
import { drawNorth } from "./compass.js";
import { last, unseen } from "./flight.js";
import { plane, sized } from "./graphics.js";
import { colourOf, look } from "./look.js";
import { extent, nice } from "./map.js";
import { lines as linesOfPlans } from "./plans.js";
import { drawSign } from "./signs.js";
import { solids } from "./solids.js";

/** @typedef {import("./flight.js").Flight} Flight */
/** @typedef {import("./messages").SnapshotMessage} Snapshot */
/** @typedef {import("./messages").VehicleRow} VehicleRow */
/** @typedef {"free" | "follow" | "first"} CameraMode */

const MOST_NAMED = 40;
const PATH_POINTS = 24000; // of all paths together
const TRAIL_POINTS = 32; // of each of many: without a graphics card each of them costs as much as the vehicle's body
const FADED = 0.8; // of a path's colour at the end of its tail
const CIRCLE = 48;
const MOST_DASHES = 401; // of one stretch
const MOST = 254;
const VIEWED_FROM = new Vector3(-0.35, 0.5, 0.72);
const FILLED = 0.88; // of the picture's width or height
const LEAST_FILLED = 0.5;
const LEAST_SPAN_M = 5;
const FRAMED_AFTER = 8; // steps that near what fills it

/** NED → the scene's axes. @param {readonly number[]} p @param {Vector3} [to] */
const place = (p, to = new Vector3()) => to.set(p[1], -p[2], -p[0]);

/** Attitude of a body (nose along −z, up along y) by roll, pitch and yaw in rad. @param {VehicleRow} row @param {Quaternion} to */
function turn(row, to) {
  const [a, b, c] = [row.heading_rad, row.pitch_rad, row.roll_rad].map((angle) => (angle ?? 0) / 2);
  const yaw = Q[0].set(0, -Math.sin(a), 0, Math.cos(a));
  const pitch = Q[1].set(Math.sin(b), 0, 0, Math.cos(b));
  const roll = Q[2].set(0, 0, -Math.sin(c), Math.cos(c));
  return to.copy(yaw).multiply(pitch).multiply(roll);
}
const Q = [new Quaternion(), new Quaternion(), new Quaternion()];

export class SpaceView {
  /** @param {HTMLCanvasElement} canvas @param {HTMLCanvasElement} names what is written over it @param {(sysid: number | null, event: MouseEvent) => void} choose */
  constructor(canvas, names, choose) {
    this.canvas = canvas;
    this.names = names;
    this.renderer = new WebGLRenderer({ canvas, antialias: false, powerPreference: "low-power" });
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(50, 1, 0.05, 5000);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.maxPolarAngle = 0.97 * Math.PI;
    this.controls.addEventListener("change", () => (this.dirty = true));
    this.dirty = true;
    /** @type {CameraMode} */
    this.mode = "free";
    const sun = new DirectionalLight(0xffffff, 2.2);
    sun.position.set(30, 80, 20);
    this.scene.add(new AmbientLight(0xffffff, 1.3), sun);
    this.material = new MeshLambertMaterial({ side: DoubleSide });
    /** @type {Map<string, InstancedMesh>} */
    this.bodies = new Map();
    this.lines = this.#segments(0);
    this.paths = this.#segments(0);
    this.scene.add(this.lines, this.paths);
    this.fixed = new Group();
    this.scene.add(this.fixed);
    /** what the fixed part was made of */
    this.madeOf = /** @type {unknown} */ (null);
    this.world = /** @type {unknown} */ (null);
    this.pathsOf = { version: -1, until_s: NaN, chosen: /** @type {number | null} */ (null), dark: false, at: 0 };
    this.size = 1;
    this.grid_m = 0;
    /** obstacles and bases @type {Mesh | null} */
    this.solid = null;
    /** @type {{sysid: number, x: number, y: number}[]} */
    this.places = [];
    this.target = new Vector3();
    this.framed = false;
    /** what the picture was framed for */
    this.framedOf = "";
    /** whether a person has moved the camera */
    this.touched = false;
    this.controls.addEventListener("start", () => (this.touched = true));
    this.width = 0;
    this.height = 0;
    let pressed = [0, 0];
    canvas.addEventListener("pointerdown", (event) => (pressed = [event.clientX, event.clientY]));
    canvas.addEventListener("pointerup", (event) => {
      if (Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4) return;
      choose(nearest(this.places, event.offsetX, event.offsetY), event);
    });
    canvas.addEventListener("keydown", (event) => this.#key(event));
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const turns = { ArrowLeft: [0.1, 0], ArrowRight: [-0.1, 0], ArrowUp: [0, 0.08], ArrowDown: [0, -0.08] }[event.key];
    const away = this.camera.position.clone().sub(this.controls.target);
    if (turns) {
      const flat = Math.hypot(away.x, away.z);
      const round = Math.atan2(away.x, away.z) - turns[0];
      const up = Math.min(Math.max(Math.atan2(away.y, flat) + turns[1], -0.2), 1.5);
      const far = away.length();
      away.set(far * Math.cos(up) * Math.sin(round), far * Math.sin(up), far * Math.cos(up) * Math.cos(round));
    } else if (event.key === "+" || event.key === "-") {
      away.multiplyScalar(event.key === "+" ? 0.85 : 1.18);
    } else if (event.key === "0") {
      return void this.whole();
    } else {
      return;
    }
    this.camera.position.copy(this.controls.target).add(away);
    this.touched = true;
    this.controls.update();
    this.dirty = true;
    event.preventDefault();
    event.stopPropagation();
  }

  whole() {
    this.framed = this.touched = false;
    this.mode = "free";
    this.dirty = true;
  }

  /** @param {number} count */
  #segments(count) {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(3 * count), 3));
    geometry.setAttribute("color", new BufferAttribute(new Float32Array(3 * count), 3));
    const made = new LineSegments(geometry, new LineBasicMaterial({ vertexColors: true, transparent: true, opacity: 0.9 }));
    made.frustumCulled = false;
    return made;
  }

  /** @param {LineSegments} segments @param {number[]} positions @param {number[]} colours */
  #fill(segments, positions, colours) {
    const geometry = segments.geometry;
    if (geometry.attributes.position.array.length < positions.length) {
      geometry.dispose();
      const fresh = new BufferGeometry();
      const room = Math.ceil(positions.length * 1.5);
      fresh.setAttribute("position", new BufferAttribute(new Float32Array(room - (room % 3)), 3));
      fresh.setAttribute("color", new BufferAttribute(new Float32Array(room - (room % 3)), 3));
      segments.geometry = fresh;
    }
    const { position, color } = segments.geometry.attributes;
    position.array.set(positions);
    color.array.set(colours);
    position.needsUpdate = color.needsUpdate = true;
    segments.geometry.setDrawRange(0, positions.length / 3);
  }

  /** Obstacles, bases, planned paths, the ground: made again only where they have changed. @param {Flight} flight @param {number} t_s */
  #fix(flight, t_s) {
    const session = flight.sessionAt(t_s);
    const wind = session?.wind;
    const key = `${JSON.stringify(wind ?? 0)} ${JSON.stringify(flight.session?.plans ?? 0)} ${flight.session?.vehicles.length} ${look().dark}`;
    if (this.madeOf === key && this.world === session && this.fixed.children.length) return;
    [this.madeOf, this.world] = [key, session];
    for (const old of this.fixed.children) if (old instanceof Mesh || old instanceof LineSegments) old.geometry.dispose();
    this.fixed.clear();
    const colours = look();
    const all = extent(flight) ?? [[-10, 10], [-10, 10]];
    const span = Math.max(all[0][1] - all[0][0], all[1][1] - all[1][0], 10);
    const step = nice(span / 6);
    const cells = 2 * Math.ceil((0.75 * span) / step);
    const ground = new GridHelper(cells * step, cells, colours.grid, colours.grid);
    const middle = (/** @type {readonly number[]} */ pair) => Math.round((pair[0] + pair[1]) / 2 / step) * step;
    ground.position.set(middle(all[1]), 0, -middle(all[0]));
    this.fixed.add(ground);
    this.solid = solids(session?.obstacles ?? [], flight.session?.bases ?? [], colours.solid);
    if (this.solid) this.fixed.add(this.solid);
    /** @type {number[]} */
    const positions = [];
    /** @type {number[]} */
    const tints = [];
    /** @param {readonly (readonly number[])[]} points @param {Color} tint @param {number} dash_m */
    const dashed = (points, tint, dash_m) => points.slice(1).forEach((to, k) => {
      const a = place(points[k]);
      const b = place(to);
      const parts = Math.min(Math.max(Math.round(a.distanceTo(b) / dash_m), 1), MOST_DASHES);
      for (let part = 0; part < parts; part += 2) {
        positions.push(...a.clone().lerp(b, part / parts).toArray(), ...a.clone().lerp(b, Math.min(part + 1, parts) / parts).toArray());
        tints.push(...tint.toArray(), ...tint.toArray());
      }
    });
    for (const member of session?.vehicles ?? []) dashed(member.path_ned, new Color(colours.soft), 0.8);
    for (const { points, colour } of linesOfPlans(flight.session)) dashed(points, new Color(colour), Math.max(span / 150, 0.8));
    if (wind) {
      const towards = ((wind.from_deg + 180) * Math.PI) / 180;
      const along = new Vector3(Math.sin(towards), 0, -Math.cos(towards));
      const middleOf = new Vector3((all[1][0] + all[1][1]) / 2, 0.12 * span, -(all[0][0] + all[0][1]) / 2);
      const length = 0.14 * span;
      const tail = middleOf.clone().addScaledVector(along, -0.62 * span);
      this.fixed.add(new ArrowHelper(along, tail, length, colours.ink, 0.3 * length, 0.14 * length));
    }
    const planned = this.#segments(0);
    this.#fill(planned, positions, tints);
    this.fixed.add(planned);
    this.grid_m = step;
    this.size = Math.min(Math.max(span / 45, 0.6), 4);
    this.scene.background = new Color(colours.paper);
  }

  /** Least and greatest places in the picture, in its halves, of what the flight covers. @param {Flight} flight */
  #covered(flight) {
    const [ns, es, ups] = extent(flight) ?? [[-4, 4], [-4, 4], [0, 0]];
    const seen = ns.flatMap((n) => es.flatMap((e) => ups.map((up) => place([n, e, -up]).project(this.camera))));
    const [xs, ys] = [seen.map((one) => one.x), seen.map((one) => one.y)];
    return { x0: Math.min(...xs), x1: Math.max(...xs), y0: Math.min(...ys), y1: Math.max(...ys), behind: seen.some((one) => one.z > 1) };
  }

  /** Whether all is in the picture, and not lost in it. @param {Flight} flight */
  #fits(flight) {
    const { x0, x1, y0, y1, behind } = this.#covered(flight);
    return !behind && x0 > -1 && x1 < 1 && y0 > -1 && y1 < 1 && Math.max(x1 - x0, y1 - y0) > 2 * LEAST_FILLED;
  }

  /** Stand so that everything fills the picture, seen from the south and above. @param {Flight} flight */
  #frame(flight) {
    const all = extent(flight);
    if (!all || !flight.count) return;
    const [[n0, n1], [e0, e1], [low, high]] = all;
    this.target.set((e0 + e1) / 2, (low + high) / 2, -(n0 + n1) / 2);
    const tall = Math.tan((this.camera.fov * Math.PI) / 360);
    const [right, up] = [new Vector3(), new Vector3()];
    let far = 4 * Math.max(n1 - n0, e1 - e0, high - low, LEAST_SPAN_M);
    for (let k = 0; k < FRAMED_AFTER; k += 1) {
      this.camera.position.copy(VIEWED_FROM).setLength(far).add(this.target);
      this.camera.lookAt(this.target);
      this.camera.updateMatrixWorld();
      const { x0, x1, y0, y1 } = this.#covered(flight);
      this.camera.matrixWorld.extractBasis(right, up, new Vector3());
      this.target.addScaledVector(right, 0.5 * (x0 + x1) * far * tall * this.camera.aspect).addScaledVector(up, 0.5 * (y0 + y1) * far * tall);
      far = Math.max((far * Math.max(x1 - x0, y1 - y0)) / (2 * FILLED), LEAST_SPAN_M);
    }
    this.controls.target.copy(this.target);
    this.controls.update();
    this.framed = true;
  }

  /**
   * @param {Flight} flight @param {Snapshot} snapshot
   * @param {{chosen: number | null, selected: Set<number>, paths: boolean, until_s: number, trail_s: number, ghosts: Flight[]}} options
   *   `ghosts`: other flights, at the same time of theirs
   */
  draw(flight, snapshot, { chosen, selected, paths, until_s, trail_s, ghosts }) {
    const box = this.canvas.getBoundingClientRect();
    if (!box.width || !box.height) return;
    if (this.width !== box.width || this.height !== box.height) {
      [this.width, this.height] = [box.width, box.height];
      this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
      this.renderer.setSize(box.width, box.height, false);
      this.camera.aspect = box.width / box.height;
      this.camera.updateProjectionMatrix();
    }
    this.#fix(flight, snapshot.t_s);
    const covers = `${extent(flight)} ${this.camera.aspect}`;
    if (!this.framed || (this.mode === "free" && !this.touched && this.framedOf !== covers && !this.#fits(flight))) {
      this.#frame(flight);
      this.framedOf = covers;
    }
    this.#bodies(snapshot, chosen);
    this.#drawLines(flight, snapshot, ghosts, until_s, paths);
    this.paths.visible = paths;
    if (paths) this.#drawPaths(flight, until_s, trail_s, chosen);
    this.#look(snapshot, chosen);
    this.renderer.render(this.scene, this.camera);
    this.#write(snapshot, chosen, selected);
    if (ghosts.length) this.#writeGhosts(ghosts, until_s);
  }

  /** Where other flights are at a time, and what they flew until then: grey. @param {Flight[]} ghosts @param {number} until_s @param {boolean} paths @param {(a: Vector3, b: Vector3) => void} line */
  #drawGhosts(ghosts, until_s, paths, line) {
    const r = 0.35 * this.size;
    for (const ghost of ghosts) {
      for (const row of ghost.at(until_s)?.vehicles ?? []) {
        if (!row.p_ned) continue;
        const here = place(row.p_ned);
        const around = [[r, 0, 0], [0, 0, r], [-r, 0, 0], [0, 0, -r]].map(([x, y, z]) => here.clone().add(new Vector3(x, y, z)));
        around.forEach((corner, k) => line(corner, around[(k + 1) % 4]));
        for (const y of [r, -r]) for (const corner of around) line(corner, here.clone().add(new Vector3(0, y, 0)));
      }
      const count = paths ? last(ghost.t_s, until_s + 1e-6, ghost.count) + 1 : 0;
      const step = Math.max(Math.ceil((count * ghost.columns.size) / PATH_POINTS), 1);
      for (const columns of ghost.columns.values()) {
        const { n, e, d } = columns;
        for (let k = 0; k + step < count; k += 2 * step) if (!unseen(columns, k) && !unseen(columns, k + step)) line(place([n[k], e[k], d[k]]), place([n[k + step], e[k + step], d[k + step]]));
      }
    }
  }

  /** @param {Flight[]} ghosts @param {number} until_s */
  #writeGhosts(ghosts, until_s) {
    const context = plane(this.names);
    const at = new Vector3();
    context.font = "11px system-ui, sans-serif";
    context.fillStyle = look().soft;
    for (const row of ghosts.flatMap((one) => one.at(until_s)?.vehicles ?? [])) {
      if (!row.p_ned) continue;
      place(row.p_ned, at).project(this.camera);
      if (at.z <= 1) context.fillText(`(${row.sysid})`, ((at.x + 1) / 2) * this.width + 9, ((1 - at.y) / 2) * this.height + 14);
    }
  }

  /** @param {Snapshot} snapshot @param {number | null} chosen */
  #bodies(snapshot, chosen) {
    const roles = new Map([["pursuer", 0], ["target", 0], ["tanker", 0]]);
    const matrix = new Matrix4();
    const attitude = new Quaternion();
    const at = new Vector3();
    const scale = new Vector3();
    const tint = new Color();
    const many = snapshot.vehicles.length > MOST_NAMED;
    for (const row of snapshot.vehicles) {
      if (!row.p_ned || (this.mode === "first" && row.sysid === chosen)) continue;
      const role = roles.has(row.role) ? row.role : "pursuer";
      const kind = `${role} ${many}`;
      let mesh = this.bodies.get(kind);
      if (!mesh) {
        mesh = new InstancedMesh(body(role, many), this.material, MOST + 1);
        mesh.frustumCulled = false;
        this.bodies.set(kind, mesh);
        this.scene.add(mesh);
      }
      const k = roles.get(role) ?? 0;
      if (k > MOST) continue;
      const grown = this.size * (row.sysid === chosen ? 1.35 : 1);
      mesh.setMatrixAt(k, matrix.compose(place(row.p_ned, at), turn(row, attitude), scale.setScalar(grown)));
      mesh.setColorAt(k, tint.set(row.alive ? colourOf(row.sysid) : look().solid));
      roles.set(role, k + 1);
    }
    for (const [kind, mesh] of this.bodies) {
      mesh.count = kind.endsWith(String(many)) ? (roles.get(kind.split(" ")[0]) ?? 0) : 0;
      mesh.instanceMatrix.needsUpdate = true;
      if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
    }
  }

  /** Rings, transfers, set points, heights, traffic. @param {Flight} flight @param {Snapshot} snapshot @param {Flight[]} ghosts @param {number} until_s @param {boolean} paths */
  #drawLines(flight, snapshot, ghosts, until_s, paths) {
    /** @type {number[]} */
    const positions = [];
    /** @type {number[]} */
    const tints = [];
    const colours = look();
    const [soft, warn, grid] = [new Color(colours.soft), new Color(colours.warn), new Color(colours.crowd.replace(/,[^,]*\)$/, ")").replace("rgba", "rgb"))];
    /** @param {Vector3} a @param {Vector3} b @param {Color} colour */
    const line = (a, b, colour) => {
      positions.push(a.x, a.y, a.z, b.x, b.y, b.z);
      tints.push(colour.r, colour.g, colour.b, colour.r, colour.g, colour.b);
    };
    const at = new Map();
    const few = snapshot.vehicles.length <= MOST_NAMED;
    const ring_m = flight.session?.ring_m ?? null;
    for (const row of snapshot.vehicles) {
      if (!row.p_ned) continue;
      const here = place(row.p_ned);
      at.set(row.sysid, here);
      if (few) line(here, here.clone().setY(0), grid);
      if (few && row.aim_ned) line(here, place(row.aim_ned), soft);
      if (row.role === "target" && ring_m !== null) {
        for (let k = 0; k < CIRCLE; k += 1) {
          const [a, b] = [k, k + 1].map((step) => (2 * Math.PI * step) / CIRCLE);
          line(
            new Vector3(here.x + ring_m * Math.cos(a), here.y, here.z + ring_m * Math.sin(a)),
            new Vector3(here.x + ring_m * Math.cos(b), here.y, here.z + ring_m * Math.sin(b)), soft,
          );
        }
      }
    }
    for (const base of flight.session?.bases ?? []) at.set(`base ${base.name}`, place(base.p_ned));
    for (const service of snapshot.services) {
      const giver = at.get(service.tanker ?? `base ${service.base}`);
      const receiver = at.get(service.receiver);
      if (!giver || !receiver) continue;
      const parts = service.phase === "transfer" ? 1 : 9;
      for (let k = 0; k < parts; k += 2) line(giver.clone().lerp(receiver, k / parts), giver.clone().lerp(receiver, (k + 1) / parts), warn);
      if (service.phase !== "transfer") continue;
      for (const y of [-0.06, 0.06]) line(giver.clone().add(new Vector3(0, y, 0)), receiver.clone().add(new Vector3(0, y, 0)), warn);
    }
    for (const craft of snapshot.traffic) {
      const here = place(craft.p_ned);
      const r = 0.6 * this.size;
      const [top, foot] = [here.clone().setY(here.y + r), here.clone().setY(here.y - r)];
      const around = [[r, 0], [0, r], [-r, 0], [0, -r]].map(([x, z]) => new Vector3(here.x + x, here.y, here.z + z));
      around.forEach((corner, k) => {
        line(top, corner, warn);
        line(foot, corner, warn);
        line(corner, around[(k + 1) % 4], warn);
      });
    }
    this.#drawGhosts(ghosts, until_s, paths, (a, b) => line(a, b, soft));
    this.#fill(this.lines, positions, tints);
  }

  /** @param {Flight} flight @param {number} until_s @param {number} trail_s @param {number | null} chosen */
  #drawPaths(flight, until_s, trail_s, chosen) {
    const dark = look().dark;
    const of = this.pathsOf;
    const now = performance.now();
    if (of.version === flight.version && of.until_s === until_s && of.chosen === chosen && of.dark === dark) return;
    // With many vehicles a path need not grow ten times a second.
    if (flight.columns.size > MOST_NAMED && now - of.at < 900 && of.chosen === chosen && of.dark === dark && until_s >= of.until_s) return;
    this.pathsOf = { version: flight.version, until_s, chosen, dark, at: now };
    const count = last(flight.t_s, until_s + 1e-6, flight.count) + 1;
    const recent = last(flight.t_s, until_s - trail_s, flight.count) + 1;
    /** @type {number[]} */
    const positions = [];
    /** @type {number[]} */
    const tints = [];
    const paper = new Color(look().paper);
    const many = flight.columns.size > MOST_NAMED;
    const [from_tint, to_tint] = [new Color(), new Color()];
    for (const [sysid, columns] of flight.columns) {
      const { n, e, d } = columns;
      const colour = new Color(colourOf(sysid));
      if (chosen === null ? many : sysid !== chosen) colour.lerp(paper, many ? 0.6 : 0.45);
      const from = sysid === chosen ? 0 : recent;
      const step = Math.max(Math.ceil((count - from) / (many ? TRAIL_POINTS : PATH_POINTS / flight.columns.size)), 1);
      const faded = (/** @type {number} */ k, /** @type {Color} */ to) => to.copy(colour).lerp(paper, sysid === chosen || !recent ? 0 : (FADED * (count - 1 - k)) / (count - from));
      for (let k = from; k < count - 1; k += step) {
        const m = Math.min(k + step, count - 1);
        if (unseen(columns, k) || unseen(columns, m)) continue;
        positions.push(e[k], -d[k], -n[k], e[m], -d[m], -n[m]);
        tints.push(...faded(k, from_tint).toArray(), ...faded(m, to_tint).toArray());
      }
    }
    this.#fill(this.paths, positions, tints);
  }

  /** Where the camera is. @param {Snapshot} snapshot @param {number | null} chosen */
  #look(snapshot, chosen) {
    const row = snapshot.vehicles.find((one) => one.sysid === chosen);
    this.controls.enabled = this.mode !== "first" || !row?.p_ned;
    if (!row?.p_ned || this.mode === "free") {
      this.controls.update();
      return;
    }
    const here = place(row.p_ned);
    if (this.mode === "follow") {
      const away = this.camera.position.clone().sub(this.controls.target);
      const far = Math.min(away.length(), 14 * this.size);
      this.controls.target.copy(here);
      this.camera.position.copy(here).add(away.setLength(Math.max(far, 2 * this.size)));
      this.camera.lookAt(here);
      return;
    }
    turn(row, this.camera.quaternion);
    this.camera.position.copy(here).add(new Vector3(0, 0.12, 0).applyQuaternion(this.camera.quaternion));
  }

  /** Names over the picture, where there is room for them. @param {Snapshot} snapshot @param {number | null} chosen @param {Set<number>} selected */
  #write(snapshot, chosen, selected) {
    const scale = Math.min(window.devicePixelRatio || 1, 2);
    const { width, height } = this;
    const many = snapshot.vehicles.length > MOST_NAMED;
    if (this.names.width !== Math.round(width * scale)) this.names.width = Math.round(width * scale);
    if (this.names.height !== Math.round(height * scale)) this.names.height = Math.round(height * scale);
    const context = plane(this.names);
    context.setTransform(scale, 0, 0, scale, 0, 0);
    context.clearRect(0, 0, width, height);
    context.font = `600 ${sized(12)}px system-ui, sans-serif`;
    const size = sized(many ? 5 : 8);
    const { ink, paper, soft, warn } = look();
    const at = new Vector3();
    this.places = [];
    /** @type {[number, number][]} */
    const taken = [];
    /** @param {string} text @param {number} x @param {number} y @param {string} colour */
    const write = (text, x, y, colour) => {
      if (taken.some(([u, w]) => Math.abs(u - x) < 24 && Math.abs(w - y) < 13)) return;
      taken.push([x, y]);
      context.lineWidth = 3;
      context.strokeStyle = paper;
      context.strokeText(text, x + 9, y - 7);
      context.fillStyle = colour;
      context.fillText(text, x + 9, y - 7);
    };
    const rows = [...snapshot.vehicles].sort((a, b) => Number(b.sysid === chosen) - Number(a.sysid === chosen) || b.severity - a.severity);
    for (const row of rows) {
      if (!row.p_ned) continue;
      place(row.p_ned, at).project(this.camera);
      if (at.z > 1) continue;
      const [x, y] = [((at.x + 1) / 2) * width, ((1 - at.y) / 2) * height];
      this.places.push({ sysid: row.sysid, x, y });
      drawSign(context, row, x, y, size);
      if (selected.has(row.sysid) && (row.sysid !== chosen || this.mode !== "first")) {
        context.strokeStyle = ink;
        context.lineWidth = row.sysid === chosen ? 2.5 : 1.5;
        context.beginPath();
        context.arc(x, y, 15, 0, 2 * Math.PI);
        context.stroke();
      }
      if (taken.length < MOST_NAMED && (!many || row.sysid === chosen || row.severity > 1 || row.role !== "pursuer")) write(String(row.sysid), x, y, ink);
    }
    for (const craft of snapshot.traffic) {
      place(craft.p_ned, at).project(this.camera);
      if (at.z <= 1) write(craft.callsign, ((at.x + 1) / 2) * width, ((1 - at.y) / 2) * height, warn);
    }
    const ahead = this.camera.getWorldDirection(at);
    drawNorth(context, width - 20, 20, Math.atan2(-ahead.x, -ahead.z));
    if (!this.grid_m) return;
    context.font = "12px system-ui, sans-serif";
    context.textAlign = "right";
    context.fillStyle = soft;
    context.fillText(`squares of ${this.grid_m} m`, width - 14, height - 10);
    context.textAlign = "left";
  }
}
