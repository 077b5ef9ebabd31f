// Bodies of the vehicles: a quadrotor of 1 m across, nose along −z, up along y.
// @ts-check
import { BoxGeometry, CircleGeometry, ConeGeometry, CylinderGeometry, OctahedronGeometry, PlaneGeometry } from "three";
import { mergeGeometries } from "three/examples/jsm/utils/BufferGeometryUtils.js";

/** A tanker carries a tank, a target a mast. @param {string} role @param {boolean} plain one of many, small */
export function body(role, plain) {
  const parts = [];
  const middle = role === "tanker" ? new BoxGeometry(0.34, 0.26, 0.6) : new BoxGeometry(0.2, 0.12, 0.28);
  if (plain) {
    for (const angle of [Math.PI / 4, -Math.PI / 4]) parts.push(new PlaneGeometry(0.34, 1.3).rotateX(-Math.PI / 2).rotateY(angle));
    parts.push(new CircleGeometry(0.3, 3).rotateX(-Math.PI / 2).rotateY(Math.PI / 2).scale(0.6, 1, 1).translate(0, 0.02, -0.3));
  } else {
    for (const [x, z] of [[1, 1], [1, -1], [-1, 1], [-1, -1]]) {
      const rotor = new CylinderGeometry(0.22, 0.22, 0.03, 10).translate(0.32 * x, 0.05, 0.32 * z);
      parts.push(rotor, new BoxGeometry(0.06, 0.05, 0.45).translate(0, 0, 0.22).rotateY(Math.atan2(x, z)));
    }
    parts.push(new ConeGeometry(0.09, 0.3, 6).rotateX(-Math.PI / 2).translate(0, 0.02, -0.28));
  }
  if (!plain || role !== "pursuer") parts.push(middle);
  const mast = new OctahedronGeometry(0.22).translate(0, 0.28, 0);
  if (role !== "target") return mergeGeometries(parts);
  return mergeGeometries([...parts, mast].map((part) => (part.index ? part.toNonIndexed() : part)));
}
