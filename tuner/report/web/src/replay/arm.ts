// The arm in the scene: shapes that follow their joints, and a joint's colour when it comes close to its limit.
import { Color, Group, Mesh, MeshStandardMaterial, type Material } from "three";
import type { Pose, Robot, Shape } from "../data";
import { ORANGE, VERMILLION } from "../palette";
import { forwardKinematics, reachOf } from "./kinematics";
import { geometryOf } from "./shapes";

/** Ratios of velocity to limit between which a joint's colour goes from its own to the warning's. */
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
  /** Those of all that is drawn, each with its opacity. */
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

  /** Colour of a joint that is far from its limit. */
  setColour(colour: string): void {
    this.own = new Color(colour);
  }

  /** As of a run that is over. */
  setFaded(faded: boolean): void {
    if (faded === this.faded) return;
    this.faded = faded;
    for (const [material, opacity] of this.opacities) {
      material.opacity = faded ? 0.4 * opacity : opacity;
      material.transparent = material.opacity < 1;
      // Whether it is opaque is compiled into its shader.
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
    // A step at the threshold, so that crossing it is seen.
    material.color.copy(this.own).lerp(warm, heat > 0 ? 0.45 + 0.55 * heat : 0);
    material.emissive.copy(warm).multiplyScalar(0.35 * heat);
  }

  /** A slim rod that ends in the tool's point. */
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
      // Where it is as good as inside the arm it stays behind it.
      polygonOffset: true,
      polygonOffsetFactor: 2,
      polygonOffsetUnits: 40,
    });
    this.opacities.set(material, opacity);
    return material;
  }
}
