// The surroundings of the arm: floor, desired path, target with the lines to it, obstacles, and parts of the
// cell.
import {
  CylinderGeometry,
  GridHelper,
  Group,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  PlaneGeometry,
  Quaternion,
  ShadowMaterial,
  SphereGeometry,
  Vector3,
} from "three";
import type { CellPart, Scenario, Vec3 } from "../data";
import { GREEN, PURPLE, VERMILLION } from "../palette";
import { cssColor } from "../theme";
import { geometryOf } from "./shapes";
import { shellMaterial } from "./shell";
import { tube } from "./tube";

/** A thin rod that can be laid between any two points. */
class Rod {
  readonly mesh: Mesh;
  constructor(radius: number, colour: string, opacity: number) {
    const geometry = new CylinderGeometry(radius, radius, 1, 10).translate(0, 0.5, 0);
    this.mesh = new Mesh(geometry, new MeshBasicMaterial({ color: colour, transparent: true, opacity }));
  }
  lay(from: Vector3, to: Vector3): void {
    const along = to.clone().sub(from);
    const length = along.length();
    this.mesh.visible = length > 1e-6;
    this.mesh.position.copy(from);
    this.mesh.scale.set(1, length, 1);
    this.mesh.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), along.normalize()));
  }
}

/** Returns a part of the cell. It is grey, so that the arm and the marks stand out. */
function part(of: CellPart): Mesh {
  const mesh = new Mesh(
    geometryOf(of.shape),
    new MeshStandardMaterial({ color: "#9aa0a6", roughness: 0.9, transparent: true, opacity: 0.75 }),
  );
  const [w, x, y, z] = of.shape.q;
  mesh.quaternion.set(x, y, z, w);
  mesh.castShadow = mesh.receiveShadow = true;
  return mesh;
}

export class Surroundings {
  readonly group = new Group();
  private readonly target: Mesh;
  private readonly sight: Rod;
  private readonly gaze: Rod;
  private readonly obstacles: Group[];
  private readonly cell: Mesh[];
  private readonly closest: Rod;
  private readonly ends: Mesh[];
  private readonly height: number;
  private floor: GridHelper | null = null;
  private pathMaterial: MeshBasicMaterial | null = null;

  constructor(
    scenario: Scenario,
    private readonly reach: number,
  ) {
    this.target = new Mesh(
      new SphereGeometry(0.02 * reach, 24, 16),
      new MeshStandardMaterial({ color: PURPLE, roughness: 0.5 }),
    );
    this.sight = new Rod(0.0022 * reach, PURPLE, 0.9);
    this.gaze = new Rod(0.0014 * reach, GREEN, 0.9);
    this.obstacles = scenario.obstacles.map((radius) => this.obstacle(radius, scenario.influence_radius));
    this.cell = scenario.cell.map(part);
    this.closest = new Rod(0.004 * reach, VERMILLION, 1);
    this.ends = [0, 1].map(
      () => new Mesh(new SphereGeometry(0.009 * reach, 20, 14), new MeshBasicMaterial({ color: VERMILLION })),
    );
    this.height = scenario.floor ?? 0;
    const shadow = new Mesh(new PlaneGeometry(6 * reach, 6 * reach), new ShadowMaterial({ opacity: 0.22 }));
    shadow.receiveShadow = true;
    shadow.position.z = this.height;
    this.group.add(this.target, this.sight.mesh, this.gaze.mesh, ...this.obstacles, shadow, this.path(scenario));
    this.group.add(...this.cell, this.closest.mesh, ...this.ends);
    this.markClosest(null);
    this.setTheme();
  }

  setTheme(): void {
    if (this.floor !== null) this.group.remove(this.floor);
    const size = Math.max(2, 2 * Math.ceil(1.6 * this.reach));
    this.floor = new GridHelper(size, size * 4, cssColor("floor-axis"), cssColor("floor"));
    this.floor.rotation.x = Math.PI / 2;
    this.floor.position.z = this.height - 0.002;
    this.group.add(this.floor);
    this.pathMaterial?.color.set(cssColor("ink-2"));
  }

  /** Moves target and obstacles. `tool`, `direction`: origin and z axis of the tool in the base frame. */
  update(tool: Vector3, direction: Vector3, target: Vec3 | null, obstacles: (Vec3 | null)[]): void {
    this.target.visible = this.sight.mesh.visible = this.gaze.mesh.visible = target !== null;
    if (target !== null) {
      this.target.position.set(...target);
      this.sight.lay(tool, this.target.position);
      const length = tool.distanceTo(this.target.position);
      this.gaze.lay(tool, tool.clone().addScaledVector(direction, length));
    }
    this.obstacles.forEach((body, i) => {
      const centre = obstacles[i] ?? null;
      body.visible = centre !== null;
      if (centre !== null) body.position.set(...centre);
    });
  }

  /** Moves the parts of the cell to these centres. A part without a centre is hidden. */
  moveCell(centres: (Vec3 | null)[]): void {
    this.cell.forEach((mesh, i) => {
      const centre = centres[i] ?? null;
      mesh.visible = centre !== null;
      if (centre !== null) mesh.position.set(...centre);
    });
  }

  /** Marks the closest points of the arm and of what it must not touch; null: none. */
  markClosest(points: [Vec3, Vec3] | null): void {
    this.closest.mesh.visible = points !== null;
    this.ends.forEach((mesh, i) => {
      const point = points?.[i];
      mesh.visible = point !== undefined;
      if (point !== undefined) mesh.position.set(...point);
    });
    if (points !== null) this.closest.lay(new Vector3(...points[0]), new Vector3(...points[1]));
  }

  private path(scenario: Scenario): Mesh {
    const points = scenario.path.map((p) => new Vector3(...p));
    const first = points[0];
    if (first !== undefined) points.push(first);
    const path = tube(points, points.map(() => [1, 1, 1]), 0.0022 * this.reach);
    this.pathMaterial = path.material as MeshBasicMaterial;
    return path;
  }

  private obstacle(body: number, influence: number): Group {
    const group = new Group();
    const ball = (radius: number, opacity: number) =>
      new Mesh(
        new SphereGeometry(radius, 32, 20),
        new MeshStandardMaterial({
          color: VERMILLION,
          roughness: 0.8,
          transparent: opacity < 1,
          opacity,
          depthWrite: opacity === 1,
        }),
      );
    group.add(ball(0.012 * this.reach, 1));
    if (body > 0) group.add(ball(body, 0.45));
    // The influence radius counts from the surface of the body.
    if (influence > 0) group.add(new Mesh(new SphereGeometry(body + influence, 48, 32), shellMaterial(VERMILLION)));
    return group;
  }
}
