// The 3D scene of one scenario: the arm of the shown run, the ghost of the reference, the tool's trail and
// the surroundings.
import { Color, Quaternion, SRGBColorSpace, Vector3, type Mesh } from "three";
import type { Robot, Run, Scenario } from "../data";
import { rampColour } from "../palette";
import { isOver } from "../runs";
import { cssColor } from "../theme";
import { Arm } from "./arm";
import { reachOf } from "./kinematics";
import { Recording } from "./recording";
import { Surroundings } from "./surroundings";
import { showSegments, tube } from "./tube";
import { Viewer } from "./viewer";

const UNTRACKED = "#8a8f98";

function linear(rgb: [number, number, number]): [number, number, number] {
  const colour = new Color().setRGB(...rgb, SRGBColorSpace);
  return [colour.r, colour.g, colour.b];
}

export class Stage {
  readonly viewer: Viewer;
  readonly shown: Recording;
  private readonly ghost: Recording | null;
  private readonly arm: Arm;
  private readonly ghostArm: Arm | null;
  private readonly around: Surroundings;
  private readonly trail: Mesh;
  private readonly scenario: Scenario;
  private time = 0;
  /** Length of the tool's trail [s]. */
  trailLength = 10;

  constructor(robot: Robot, scenario: Scenario, run: Run, reference: Run | null, errorScale: number) {
    const reach = reachOf(robot);
    this.scenario = scenario;
    this.viewer = new Viewer(reach);
    this.shown = new Recording(run);
    this.ghost = reference === null ? null : new Recording(reference);
    this.arm = new Arm(robot, false);
    this.ghostArm = this.ghost === null ? null : new Arm(robot, true);
    this.around = new Surroundings(scenario, reach);
    this.trail = this.makeTrail(reach, errorScale);
    this.viewer.add(this.around.group, this.trail, this.arm.group);
    if (this.ghostArm !== null) this.viewer.add(this.ghostArm.group);
    this.lookAtPath(reach);
    this.setTheme();
  }

  setTheme(): void {
    this.arm.setColour(cssColor("arm"));
    this.around.setTheme();
    this.show(this.time);
  }

  showGhost(shown: boolean): void {
    if (this.ghostArm !== null) this.ghostArm.group.visible = shown;
    this.viewer.draw();
  }

  show(time: number): void {
    this.time = time;
    const { shown, ghost } = this;
    const tool = this.arm.update(shown.jointsAt(time), shown.ratiosAt(time));
    this.arm.setFaded(isOver(shown.run, time));
    if (ghost !== null) {
      this.ghostArm?.update(ghost.jointsAt(time), []);
      this.ghostArm?.setFaded(isOver(ghost.run, time));
    }
    const point = new Vector3(...tool.p);
    const direction = new Vector3(0, 0, 1).applyQuaternion(new Quaternion(tool.q[1], tool.q[2], tool.q[3], tool.q[0]));
    // After the end of the shown run, target and obstacles move as in the reference.
    const world = ghost !== null && time > shown.end && ghost.end > shown.end ? ghost : shown;
    const obstacles = this.scenario.obstacles.map((_, i) => world.obstacleAt(i, time));
    this.around.update(point, direction, world.targetAt(time), obstacles);
    this.around.moveCell(this.scenario.cell.map((_, i) => world.partAt(i, time)));
    this.around.markClosest(shown.closestAt(time));
    const last = Math.min(Math.floor(time / shown.dt), shown.n - 1);
    showSegments(this.trail, Math.max(0, last - Math.round(this.trailLength / shown.dt)), last);
    this.viewer.draw();
  }

  private makeTrail(reach: number, errorScale: number): Mesh {
    const [x, y, z] = this.shown.tool;
    const points: Vector3[] = [];
    const colours: [number, number, number][] = [];
    const untracked = new Color(UNTRACKED);
    for (let i = 0; i < this.shown.n; ++i) {
      points.push(new Vector3(x?.[i] || 0, y?.[i] || 0, z?.[i] || 0));
      const error = this.shown.error[i] ?? NaN;
      colours.push(
        Number.isFinite(error) && errorScale > 0
          ? linear(rampColour(error / errorScale))
          : [untracked.r, untracked.g, untracked.b],
      );
    }
    return tube(points, colours, 0.0048 * reach);
  }

  /** Looks from the side, with the path in the foreground. */
  private lookAtPath(reach: number): void {
    const centre = new Vector3();
    for (const p of this.scenario.path) centre.add(new Vector3(...p));
    if (this.scenario.path.length > 0) centre.divideScalar(this.scenario.path.length);
    const heading = centre.lengthSq() > 1e-9 ? Math.atan2(centre.y, centre.x) : 0;
    const side = heading + 0.95;
    const at = new Vector3(0.45 * centre.x, 0.45 * centre.y, 0.24 * reach);
    const far = 1.5 * reach;
    this.viewer.look(new Vector3(far * Math.cos(side), far * Math.sin(side), 0.5 * reach).add(at), at);
  }
}
