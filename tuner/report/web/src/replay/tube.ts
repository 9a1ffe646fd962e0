// A line with thickness and colours. WebGL lines are only one pixel wide on most machines.
import { BufferAttribute, BufferGeometry, Mesh, MeshBasicMaterial, Vector3 } from "three";

const SIDES = 6;

/** Returns a tube through the points. colours: one per point. Segment i, from point i to point i + 1, has the
 * indices from SIDES * 6 * i to SIDES * 6 * (i + 1) - 1. */
export function tube(points: Vector3[], colours: [number, number, number][], radius: number): Mesh {
  const position = new Float32Array(points.length * SIDES * 3);
  const colour = new Float32Array(points.length * SIDES * 3);
  const side = new Vector3();
  const tangent = new Vector3(0, 0, 1);
  const up = new Vector3();
  points.forEach((point, i) => {
    const step = (points[i + 1] ?? point).clone().sub(points[i - 1] ?? point);
    // While the tool stands still, the tangent keeps its direction.
    if (step.lengthSq() > 1e-16) tangent.copy(step).normalize();
    up.set(0, 0, 1);
    if (Math.abs(tangent.z) > 0.95) up.set(1, 0, 0);
    side.crossVectors(tangent, up).normalize();
    up.crossVectors(side, tangent);
    const [r, g, b] = colours[i] ?? [0.5, 0.5, 0.5];
    for (let k = 0; k < SIDES; ++k) {
      const angle = (2 * Math.PI * k) / SIDES;
      const c = radius * Math.cos(angle);
      const s = radius * Math.sin(angle);
      const at = 3 * (i * SIDES + k);
      position[at] = point.x + c * side.x + s * up.x;
      position[at + 1] = point.y + c * side.y + s * up.y;
      position[at + 2] = point.z + c * side.z + s * up.z;
      colour[at] = r;
      colour[at + 1] = g;
      colour[at + 2] = b;
    }
  });
  const index: number[] = [];
  for (let i = 0; i + 1 < points.length; ++i) {
    for (let k = 0; k < SIDES; ++k) {
      const a = i * SIDES + k;
      const b = i * SIDES + ((k + 1) % SIDES);
      index.push(a, b, a + SIDES, b, b + SIDES, a + SIDES);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(position, 3));
  geometry.setAttribute("color", new BufferAttribute(colour, 3));
  geometry.setIndex(index);
  const mesh = new Mesh(geometry, new MeshBasicMaterial({ vertexColors: true }));
  mesh.frustumCulled = false;
  return mesh;
}

/** Shows the segments from point `from` to point `to` only. */
export function showSegments(mesh: Mesh, from: number, to: number): void {
  mesh.geometry.setDrawRange(from * SIDES * 6, Math.max(to - from, 0) * SIDES * 6);
}
