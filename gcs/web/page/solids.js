// Obstacles and bases as one mesh: without a graphics card a hundred meshes cost more than all else in the picture.
// @ts-check
import { BufferAttribute, BufferGeometry, CylinderGeometry, FrontSide, Mesh, MeshLambertMaterial, OctahedronGeometry, ShapeUtils, SphereGeometry, Vector2 } from "three";
import { mergeGeometries } from "three/examples/jsm/utils/BufferGeometryUtils.js";

/** @typedef {import("./messages").SessionLine} SessionLine */

const MOST_SIDES = 16;

/** A prism with flat sides and a roof. @param {[number, number][]} outline_ne @param {number} top_d @param {number} bottom_d */
export function prism(outline_ne, top_d, bottom_d) {
  const step = Math.max(Math.ceil(outline_ne.length / MOST_SIDES), 1);
  const corners = outline_ne.filter((_, k) => k % step === 0).map(([n, e]) => new Vector2(e, n));
  if (ShapeUtils.isClockWise(corners)) corners.reverse();
  const [high, low] = [-top_d, -Math.max(bottom_d, top_d + 0.05)];
  /** @type {number[][]} */
  const [positions, normals, index] = [[], [], []];
  corners.forEach((a, k) => {
    const b = corners[(k + 1) % corners.length];
    const length = a.distanceTo(b) || 1;
    for (const [corner, y] of /** @type {[Vector2, number][]} */ ([[a, low], [b, low], [b, high], [a, high]])) {
      positions.push(corner.x, y, -corner.y);
      normals.push((b.y - a.y) / length, 0, (b.x - a.x) / length);
    }
    index.push(...[0, 1, 2, 0, 2, 3].map((i) => 4 * k + i));
  });
  const first = positions.length / 3;
  for (const corner of corners) {
    positions.push(corner.x, high, -corner.y);
    normals.push(0, 1, 0);
  }
  for (const face of ShapeUtils.triangulateShape(corners, [])) index.push(...face.map((i) => first + i));
  const made = new BufferGeometry();
  made.setAttribute("position", new BufferAttribute(new Float32Array(positions), 3));
  made.setAttribute("normal", new BufferAttribute(new Float32Array(normals), 3));
  return made.setIndex(index);
}

/** @param {BufferGeometry} geometry with indices, and at most with coordinates of textures besides @param {readonly number[]} p_ned */
function placed(geometry, p_ned) {
  geometry.deleteAttribute("uv");
  if (!geometry.index) geometry.setIndex([...Array(geometry.attributes.position.count).keys()]);
  return geometry.translate(p_ned[1], -p_ned[2], -p_ned[0]);
}

/** @param {SessionLine["obstacles"]} obstacles @param {SessionLine["bases"]} bases @param {string} colour @returns {Mesh | null} null where there are none */
export function solids(obstacles, bases, colour) {
  const parts = obstacles.map((one) => {
    if (one.kind === "sphere") return placed(new SphereGeometry(one.radius_m ?? 0.5, 20, 14), one.centre_ned);
    if (!one.outline_ne.length) return placed(new OctahedronGeometry(0.3), one.centre_ned);
    return prism(one.outline_ne, one.top_d, one.bottom_d);
  });
  parts.push(...bases.map((base) => placed(new CylinderGeometry(1, 1, 0.1, 24), base.p_ned)));
  if (!parts.length) return null;
  // Translucent faces of one mesh are drawn in no order by distance: with none in the buffer of depths, none hides another.
  const material = new MeshLambertMaterial({ color: colour, transparent: true, opacity: 0.6, side: FrontSide, depthWrite: false });
  return new Mesh(mergeGeometries(parts), material);
}
