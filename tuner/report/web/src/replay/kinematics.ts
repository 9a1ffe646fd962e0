// Forward kinematics of the chain: computes the frames of joints and tool in the base frame from the joint
// positions.
import type { Pose, Quaternion, Robot, Vec3 } from "../data";

export function multiply(a: Quaternion, b: Quaternion): Quaternion {
  const [aw, ax, ay, az] = a;
  const [bw, bx, by, bz] = b;
  return [
    aw * bw - ax * bx - ay * by - az * bz,
    aw * bx + ax * bw + ay * bz - az * by,
    aw * by - ax * bz + ay * bw + az * bx,
    aw * bz + ax * by - ay * bx + az * bw,
  ];
}

/** Returns v + 2 w (u x v) + 2 u x (u x v), where u is the vector part of q. */
export function rotate(q: Quaternion, v: Vec3): Vec3 {
  const [w, x, y, z] = q;
  const cx = y * v[2] - z * v[1];
  const cy = z * v[0] - x * v[2];
  const cz = x * v[1] - y * v[0];
  return [
    v[0] + 2 * (w * cx + y * cz - z * cy),
    v[1] + 2 * (w * cy + z * cx - x * cz),
    v[2] + 2 * (w * cz + x * cy - y * cx),
  ];
}

export function compose(a: Pose, b: Pose): Pose {
  const moved = rotate(a.q, b.p);
  return { p: [a.p[0] + moved[0], a.p[1] + moved[1], a.p[2] + moved[2]], q: multiply(a.q, b.q) };
}

/** Returns the motion of a joint about or along its z axis. */
function motion(kind: "revolute" | "prismatic", position: number): Pose {
  if (kind === "prismatic") return { p: [0, 0, position], q: [1, 0, 0, 0] };
  return { p: [0, 0, 0], q: [Math.cos(position / 2), 0, 0, Math.sin(position / 2)] };
}

/** Returns the pose of each joint's frame after its own motion, and the pose of the tool. */
export function forwardKinematics(robot: Robot, positions: ArrayLike<number>): { joints: Pose[]; tool: Pose } {
  let frame: Pose = { p: [0, 0, 0], q: [1, 0, 0, 0] };
  const joints = robot.joints.map((joint, i) => {
    frame = compose(compose(frame, { p: joint.p, q: joint.q }), motion(joint.kind, positions[i] ?? 0));
    return frame;
  });
  return { joints, tool: compose(frame, robot.tool) };
}

/** Returns an upper bound of the distance of the chain from the base [m]. */
export function reachOf(robot: Robot): number {
  const lengths = [...robot.joints.map((joint) => joint.p), robot.tool.p].map((p) => Math.hypot(...p));
  const strokes = robot.joints.map((joint) =>
    joint.kind === "prismatic" ? Math.max(Math.abs(joint.lower ?? 0), Math.abs(joint.upper ?? 0)) : 0,
  );
  return [...lengths, ...strokes].reduce((sum, length) => sum + length, 0);
}
