// Makes the geometry of links.
import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  CapsuleGeometry,
  CylinderGeometry,
  SphereGeometry,
} from "three";
import type { Shape } from "../data";
import { decodeFloats } from "../decode";

/** Turns a cylinder of three.js, which is along y, to the z axis. */
function alongZ(geometry: BufferGeometry): BufferGeometry {
  return geometry.rotateX(Math.PI / 2);
}

export function geometryOf(shape: Shape): BufferGeometry {
  const [a = 0.05, b = a, c = a] = shape.size;
  switch (shape.kind) {
    case "box":
      return new BoxGeometry(a, b, c);
    case "sphere":
      return new SphereGeometry(a, 32, 20);
    case "cylinder":
      return alongZ(new CylinderGeometry(a, a, b, 40));
    case "capsule":
      return alongZ(new CapsuleGeometry(a, b, 10, 28));
    case "shape without size":
      return new BufferGeometry();
    case "mesh": {
      const [sx = 1, sy = 1, sz = 1] = shape.size;
      const geometry = new BufferGeometry();
      geometry.setAttribute("position", new BufferAttribute(decodeFloats(shape.triangles ?? ""), 3));
      geometry.scale(sx, sy, sz);
      geometry.computeVertexNormals();
      return geometry;
    }
  }
}
