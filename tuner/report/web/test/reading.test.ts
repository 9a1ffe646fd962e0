import assert from "node:assert/strict";
import { test } from "node:test";
import { alignRuns } from "../src/plots/align";
import { formatReading, valueAt } from "../src/plots/reading";
import { bandsOf } from "../src/plots/time_plots";

test("a value between two points is on the line that is drawn between them", () => {
  const [time, values] = [[0, 1, 3], [2, 4, 0]];
  assert.equal(valueAt(time, values, 0.5, 3), 3);
  assert.equal(valueAt(time, values, 2, 3), 2);
  time.forEach((t, i) => assert.equal(valueAt(time, values, t, 3), values[i]));
});

test("two points at one time are no division by zero", () => {
  assert.equal(valueAt([0, 1, 1, 2], [0, 1, 5, 5], 1, 2), 5);
});

test("a gap is no value, and ends half way to it", () => {
  const values = [1, NaN, 3];
  assert.equal(valueAt([0, 1, 2], values, 0.4, 2), 1);
  assert.ok(Number.isNaN(valueAt([0, 1, 2], values, 1, 2)));
  assert.equal(valueAt([0, 1, 2], values, 1.6, 2), 3);
});

test("after the run's end there is no value, up to it the last one", () => {
  assert.equal(valueAt([0, 1], [5, 6], 1.05, 1.1), 6);
  assert.ok(Number.isNaN(valueAt([0, 1], [5, 6], 1.2, 1.1)));
  assert.ok(Number.isNaN(valueAt([], [], 0, 1)));
});

test("a reading has no digit below the step of its series, and three at most", () => {
  // A step of 2e-5: a hundred-thousandth more is not told apart.
  assert.equal(formatReading(0.001234, 2e-5), "0.0012");
  assert.equal(formatReading(0.00001, 2e-5), "0");
  assert.equal(formatReading(123.456, 2e-5), "123");
  assert.equal(formatReading(-0.12345, 0.01), "−0.12");
  assert.equal(formatReading(0.0012345, 0), "0.00123");
  assert.equal(formatReading(NaN, 0.1), "–");
  assert.equal(formatReading(0.0123, 0.001), "0.012");
});

test("a column's gap stays one when runs of different times share an axis, and other runs' points are drawn through", () => {
  const one = { time: Float64Array.of(0, 1, 2), columns: [Float64Array.of(1, NaN, 3)] };
  const other = { time: Float64Array.of(0, 0.5), columns: [Float64Array.of(7, 8)] };
  const { x, columns } = alignRuns([one, other], 1);
  assert.deepEqual(x, [0, 0.5, 1, 2]);
  assert.deepEqual([...(columns[0] ?? [])], [1, undefined, null, 3]);
  assert.deepEqual([...(columns[1] ?? [])], [7, 8, undefined, undefined]);
});

test("bands end with the run", () => {
  const constant = { lo: 0, hi: 0, u16: "" };
  const replay = { dt: 1, n: 0, q: [], target: [], obstacles: [], cell: [], closest: [], tool: [], error: constant, velocity_ratio: [] };
  const run = {
    set: 0, status: "diverged", reason: "", start: 0, end: 4, time: constant, columns: [], replay,
    states: [{ t: 0, state: 1 }, { t: 1, state: 0 }, { t: 3, state: 1 }],
    slerps: [[3, 9]] as [number, number][],
  };
  const scenario = {
    name: "", duration: 10, path: [], influence_radius: 0, obstacles: [], cell: [], floor: null, states: ["followTrajectory", "avoidObstacles"], robot: 0, runs: [run],
  };
  const bands = bandsOf(run, scenario).map(({ from, to }) => [from, to]);
  assert.deepEqual(bands, [[0, 1], [3, 4], [3, 4]]);
});
