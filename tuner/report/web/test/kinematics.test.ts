import assert from "node:assert/strict";
import { test } from "node:test";
import type { Joint, Quaternion, Robot, Vec3 } from "../src/data";
import { compose, forwardKinematics, multiply, reachOf, rotate } from "../src/replay/kinematics";

// Chains of a handful of products of numbers of order one: rounding stays far below this.
const ROUNDING = 1e-12;

function near(a: readonly number[], b: readonly number[], what = ""): void {
  assert.equal(a.length, b.length);
  a.forEach((value, i) => assert.ok(Math.abs(value - (b[i] ?? NaN)) < ROUNDING, `${what} ${String(a)} is not ${String(b)}`));
}

/** Numbers from a generator that is named: x <- 16807 x mod 2^31 - 1 (Park and Miller 1988). */
function generator(seed: number): () => number {
  let x = seed;
  return () => (x = (16807 * x) % 2147483647) / 2147483647;
}

function someQuaternion(next: () => number): Quaternion {
  const v = [next() - 0.5, next() - 0.5, next() - 0.5, next() - 0.5] as const;
  const n = Math.hypot(...v);
  return [v[0] / n, v[1] / n, v[2] / n, v[3] / n];
}

function someVector(next: () => number): Vec3 {
  return [next() - 0.5, next() - 0.5, next() - 0.5];
}

function joint(p: Vec3, q: Quaternion, kind: Joint["kind"] = "revolute"): Joint {
  return { name: "j", kind, p, q, velocity_limit: 1, effort_limit: 1, lower: null, upper: null };
}

function robot(joints: Joint[], tool: Vec3): Robot {
  return { name: "r", joints, shapes: [], undrawn: 0, tool: { p: tool, q: [1, 0, 0, 0] } };
}

/** Rotation matrix of a quaternion, from the textbook's nine entries: not the way rotate() goes. */
function matrix([w, x, y, z]: Quaternion): number[][] {
  return [
    [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
  ];
}

function times(m: number[][], v: number[]): number[] {
  return m.map((row) => row.reduce((sum, value, k) => sum + value * (v[k] ?? 0), 0));
}

test("a quaternion turns a vector as its matrix does", () => {
  const next = generator(1);
  for (let i = 0; i < 50; ++i) {
    const q = someQuaternion(next);
    const v = someVector(next);
    near(rotate(q, v), times(matrix(q), v));
  }
});

test("the product of quaternions turns as one after the other", () => {
  const next = generator(2);
  for (let i = 0; i < 50; ++i) {
    const [a, b, v] = [someQuaternion(next), someQuaternion(next), someVector(next)];
    near(rotate(multiply(a, b), v), rotate(a, rotate(b, v)));
  }
});

test("composing poses is associative", () => {
  const next = generator(3);
  const pose = () => ({ p: someVector(next), q: someQuaternion(next) });
  for (let i = 0; i < 20; ++i) {
    const [a, b, c] = [pose(), pose(), pose()];
    const left = compose(compose(a, b), c);
    const right = compose(a, compose(b, c));
    near(left.p, right.p);
    near(left.q, right.q);
  }
});

test("a planar arm's tool is where sines and cosines put it", () => {
  const arm = robot([joint([0, 0, 0], [1, 0, 0, 0]), joint([0.7, 0, 0], [1, 0, 0, 0])], [0.4, 0, 0]);
  for (const [a, b] of [[0, 0], [0.3, -1.2], [2, 2.5]] as const) {
    const { tool } = forwardKinematics(arm, [a, b]);
    near(tool.p, [0.7 * Math.cos(a) + 0.4 * Math.cos(a + b), 0.7 * Math.sin(a) + 0.4 * Math.sin(a + b), 0]);
  }
});

test("a prismatic joint moves what follows along its own z", () => {
  const half = Math.SQRT1_2;
  // z of the joint is x of the base: turned by a right angle about y.
  const arm = robot([joint([0, 0, 1], [half, 0, half, 0], "prismatic")], [0, 0, 0.2]);
  near(forwardKinematics(arm, [0.5]).tool.p, [0.7, 0, 1]);
});

test("turning the last joint moves nothing on its axis", () => {
  const next = generator(4);
  const arm = robot(
    [0, 1, 2].map(() => joint(someVector(next), someQuaternion(next))),
    [0, 0, 0.3],
  );
  const here = forwardKinematics(arm, [0.1, 0.2, 0.3]).tool.p;
  near(forwardKinematics(arm, [0.1, 0.2, 1.9]).tool.p, here);
});

test("small turns move the tool as the axis crossed with the lever says", () => {
  const next = generator(5);
  const arm = robot(
    [0, 1, 2, 3].map(() => joint(someVector(next), someQuaternion(next))),
    someVector(next),
  );
  const q = [0.4, -0.7, 1.1, 0.2];
  const h = 1e-5;
  const { joints, tool } = forwardKinematics(arm, q);
  joints.forEach((pose, i) => {
    const [ax, ay, az] = rotate(pose.q, [0, 0, 1]);
    const [rx, ry, rz] = tool.p.map((value, k) => value - (pose.p[k] ?? 0)) as Vec3;
    const cross = [ay * rz - az * ry, az * rx - ax * rz, ax * ry - ay * rx];
    const at = (step: number) => forwardKinematics(arm, q.map((value, k) => (k === i ? value + step : value))).tool.p;
    const [plus, minus] = [at(h), at(-h)];
    cross.forEach((value, k) => {
      const slope = ((plus[k] ?? 0) - (minus[k] ?? 0)) / (2 * h);
      // Central differences: h^2 / 6 of a third derivative of order one, and rounding over h.
      assert.ok(Math.abs(slope - value) < 1e-9, `joint ${i}`);
    });
  });
});

test("no pose takes the tool beyond the reach", () => {
  const next = generator(6);
  const arm = robot(
    [0, 1, 2, 3, 4].map(() => joint(someVector(next), someQuaternion(next))),
    someVector(next),
  );
  const reach = reachOf(arm);
  for (let i = 0; i < 200; ++i) {
    const q = arm.joints.map(() => 6.28 * next());
    assert.ok(Math.hypot(...forwardKinematics(arm, q).tool.p) <= reach * (1 + ROUNDING));
  }
});
