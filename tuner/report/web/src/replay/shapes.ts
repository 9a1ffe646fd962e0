// Geometry of links.
import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  CapsuleGeometry,
  CylinderGeometry,
  SphereGeometry,
} from "three";
import type { Robot, Shape, Vec3 } from "../data";
import { decodeFloats } from "../decode";

/** three's cylinders stand along y, ours along z. */
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

/** Turns z onto the direction: (1 + z.d, z x d), normalised. */
function turnOntoZ([x, y, z]: Vec3): [number, number, number, number] {
  if (z < -0.999999) return [0, 1, 0, 0];
  const length = Math.hypot(1 + z, x, y);
  return [(1 + z) / length, -y / length, x / length, 0];
}

/** Capsules from joint to joint, for an arm without shapes. */
export function stickShapes(robot: Robot, radius: number): Shape[] {
  const ends = [...robot.joints.map((joint) => joint.p), robot.tool.p];
  return ends.flatMap((p, i): Shape[] => {
    const length = Math.hypot(...p);
    if (length < 1e-6) return [];
    const direction: Vec3 = [p[0] / length, p[1] / length, p[2] / length];
    return [
      {
        joint: i - 1,
        p: [p[0] / 2, p[1] / 2, p[2] / 2],
        q: turnOntoZ(direction),
        kind: "capsule",
        size: [radius, length],
      },
    ];
  });
}
