import assert from "node:assert/strict";
import { test } from "node:test";
import type { PlanLimit } from "../src/data";
import { boundWords, limitLines } from "../src/plots/limit_lines";
import { speedFor } from "../src/playhead";
import { binding, stretchWords } from "../src/sections/plan";

const limit = (part: string, upper: number, more: Partial<PlanLimit> = {}): PlanLimit => ({
  limit: "velocity",
  part,
  words: `velocity of ${part}`,
  unit: "rad/s",
  lower: -upper,
  upper,
  from: 0,
  to: 2,
  at_knots: 1,
  between_knots: 1,
  active: 0,
  strength: 0,
  active_lower: [],
  active_upper: [],
  group: "joint_velocity",
  column: `joint/${part}/velocity`,
  ...more,
});
const colour = (column: string) => `of ${column}`;

test("a bound that all joints share is one dashed line on either side", () => {
  const { lines, far } = limitLines([limit("a", 2), limit("b", 2)], 1.5, 1, colour);
  assert.deepEqual(lines.map((line) => [line.value, line.label, line.thick ?? false]), [[-2, "limit", false], [2, "limit", false]]);
  assert.deepEqual(far, []);
});

test("bounds of single joints have their curves' colours and names", () => {
  const { lines } = limitLines([limit("a", 2), limit("b", 3)], 1.5, 1, colour);
  assert.equal(lines.length, 4);
  assert.deepEqual(new Set(lines.map((line) => line.colour)), new Set(["of joint/a/velocity", "of joint/b/velocity"]));
  assert.ok(lines.every((line) => line.label === (line.value === 2 || line.value === -2 ? "limit of a" : "limit of b")));
});

test("where a limit holds the plan back its line is thick, on its own side and in its curve's colour", () => {
  const one = limit("a", 2, { active_lower: [[0.5, 0.75]], active_upper: [[1, 1], [1.5, 2]] });
  const thick = limitLines([one, limit("b", 2)], 1.5, 1000, colour).lines.filter((line) => line.thick);
  assert.deepEqual(thick.map(({ value, from, to }) => [value, from, to]), [[-2000, 0.5, 0.75], [2000, 1, 1], [2000, 1.5, 2]]);
  assert.ok(thick.every((line) => line.colour === "of joint/a/velocity"));
});

test("a limit far out of what is plotted is named and not drawn, unless it is active", () => {
  const quiet = limitLines([limit("a", 6.28), limit("b", 0.4)], 0.3, 1, colour);
  assert.deepEqual(quiet.far.map((one) => one.part), ["a"]);
  assert.ok(quiet.lines.every((line) => Math.abs(line.value) < 1));
  const active = limitLines([limit("a", 6.28, { active_upper: [[0, 1]] })], 0.3, 1, colour);
  assert.ok(active.lines.some((line) => line.value === 6.28 && line.thick === true));
});

test("of labels that would lie over each other one is left", () => {
  const { lines } = limitLines([limit("a", 3.15), limit("b", 3.2), limit("c", 2)], 3, 1, colour);
  assert.deepEqual(lines.filter((line) => line.label !== "" && line.value > 0).map((line) => line.label), ["limit of a", "limit of c"]);
});

test("lines end where their limit does", () => {
  const { lines } = limitLines([limit("angle", 0.15, { lower: null, from: 0.136, to: 0.636 })], 0.5, 1, colour);
  assert.deepEqual(lines.map(({ value, from, to }) => [value, from, to]), [[0.15, 0.136, 0.636]]);
});

test("bounds in words keep their unit and their sides", () => {
  assert.equal(boundWords(limit("a", 2)), "± 2 rad/s");
  assert.equal(boundWords({ lower: null, upper: 0.15, unit: "rad" }), "at most 0.15 rad");
  assert.equal(boundWords({ lower: 0.3, upper: null, unit: "m" }), "at least 0.3 m");
  assert.equal(boundWords({ lower: -1, upper: 2, unit: "m/s^2" }), "−1 to 2 m/s²");
});

test("the strongest limits come first, and those that hold nothing back not at all", () => {
  const all = [limit("a", 1, { strength: 1 }), limit("b", 1), limit("c", 1, { strength: 3 })];
  assert.deepEqual(binding(all).map((one) => one.part), ["c", "a"]);
});

test("stretches are told in order of time whatever their side", () => {
  assert.equal(stretchWords({ active_lower: [[0.5, 0.6]], active_upper: [[0.1, 0.1]] }), "at 0.100, 0.500 to 0.600 s");
  assert.equal(stretchWords({ active_lower: [], active_upper: [[0, 1], [2, 3], [4, 5], [6, 7], [8, 9]] }), "0.000 to 1.000, 2.000 to 3.000, 4.000 to 5.000 s and 2 more");
  assert.equal(stretchWords({ active_lower: [], active_upper: [] }), "");
});

test("short motions are played slowly enough to be seen, long ones at their true speed", () => {
  for (const duration of [0.13, 0.6, 1.1, 3, 10, 60]) {
    const speed = speedFor(duration);
    assert.ok(speed <= 1);
    assert.ok(speed === 1 ? duration >= 3 : duration / speed >= 3 || speed === 0.1, `${duration} s at ${speed}`);
  }
});
