// The arm in the scene. Its shapes follow their joints. A joint changes its colour close to its velocity
// limit.
import { Color, Group, Mesh, MeshStandardMaterial, type Material } from "three";
import type { Pose, Robot, Shape } from "../data";
import { ORANGE, VERMILLION } from "../palette";
import { forwardKinematics, reachOf } from "./kinematics";
import { geometryOf } from "./shapes";

/** Ratio of velocity to limit from which a joint's colour changes; at WARN_TO it is the warning colour. */
export const WARN_FROM = 0.8;
const WARN_TO = 1;

function place(object: Group | Mesh, pose: Pose): void {
  object.position.set(...pose.p);
  object.quaternion.set(pose.q[1], pose.q[2], pose.q[3], pose.q[0]);
}

export class Arm {
  readonly group = new Group();
  private readonly links: Group[];
  private readonly materials: MeshStandardMaterial[] = [];
  /** All materials, each with its opacity. */
  private readonly opacities = new Map<MeshStandardMaterial, number>();
  private readonly tool = new Group();
  private faded = false;
  private own = new Color("#b9c2cc");

  constructor(
    private readonly robot: Robot,
    private readonly ghost: boolean,
  ) {
    const base = new Group();
    this.links = robot.joints.map(() => new Group());
    this.group.add(base, ...this.links, this.tool);
    const reach = reachOf(robot);
    const ghostly = ghost ? this.ghostMaterial() : null;
    const materials = [-1, ...robot.joints.keys()].map(() => ghostly ?? this.solidMaterial());
    for (const shape of robot.shapes) {
      const mesh = new Mesh(geometryOf(shape), materials[shape.joint + 1] ?? this.solidMaterial());
      mesh.castShadow = !ghost;
      place(mesh, shape);
      (shape.joint < 0 ? base : this.links[shape.joint])?.add(mesh);
    }
    this.materials = ghost ? [] : materials.slice(1);
    this.addTool(ghostly ?? this.solidMaterial(), reach);
  }

  /** Sets the colour of joints that are far from their limits. */
  setColour(colour: string): void {
    this.own = new Color(colour);
  }

  /** True: draws the arm faded, because its run is over. */
  setFaded(faded: boolean): void {
    if (faded === this.faded) return;
    this.faded = faded;
    for (const [material, opacity] of this.opacities) {
      material.opacity = faded ? 0.4 * opacity : opacity;
      material.transparent = material.opacity < 1;
      // The shader must be compiled again when it becomes opaque or transparent.
      material.needsUpdate = true;
    }
  }

  update(positions: number[], ratios: number[]): Pose {
    const { joints, tool } = forwardKinematics(this.robot, positions);
    joints.forEach((pose, i) => {
      const link = this.links[i];
      if (link !== undefined) place(link, pose);
    });
    place(this.tool, tool);
    this.materials.forEach((material, i) => this.colour(material, ratios[i] || 0));
    return tool;
  }

  private colour(material: MeshStandardMaterial, ratio: number): void {
    const heat = Math.min(Math.max((ratio - WARN_FROM) / (WARN_TO - WARN_FROM), 0), 1);
    const warm = new Color(ORANGE).lerp(new Color(VERMILLION), heat);
    // The colour makes a step at the threshold, so that crossing it is visible.
    material.color.copy(this.own).lerp(warm, heat > 0 ? 0.45 + 0.55 * heat : 0);
    material.emissive.copy(warm).multiplyScalar(0.35 * heat);
  }

  /** Adds a slim rod that ends at the tool's origin. */
  private addTool(material: Material, reach: number): void {
    const [x, y, z] = this.robot.tool.p;
    const length = Math.hypot(x, y, z);
    if (length < 1e-6) return;
    const shown = Math.min(length, 0.12 * reach);
    const shape: Shape = {
      joint: this.robot.joints.length - 1,
      p: [0, 0, -shown / 2],
      q: [1, 0, 0, 0],
      kind: "cylinder",
      size: [0.009 * reach, shown],
    };
    const mesh = new Mesh(geometryOf(shape), material);
    mesh.castShadow = !this.ghost;
    place(mesh, shape);
    this.tool.add(mesh);
  }

  private solidMaterial(): MeshStandardMaterial {
    const material = new MeshStandardMaterial({ color: this.own, roughness: 0.55, metalness: 0.15 });
    this.opacities.set(material, 1);
    return material;
  }

  private ghostMaterial(): MeshStandardMaterial {
    const opacity = 0.4;
    const material = new MeshStandardMaterial({
      color: ORANGE,
      roughness: 0.9,
      transparent: true,
      opacity,
      // Where the ghost coincides with the arm, the arm is in front.
      polygonOffset: true,
      polygonOffsetFactor: 2,
      polygonOffsetUnits: 40,
    });
    this.opacities.set(material, opacity);
    return material;
  }
}
