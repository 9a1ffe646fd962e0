import assert from "node:assert/strict";
import { test } from "node:test";
import { bestLine, bestSoFar, countsOf, numberOf, phaseRuns, undrawnText } from "../src/plots/evaluations";
import { boundOf, placeOnScale } from "../src/plots/place_on_scale";
import { scaleUnit } from "../src/plots/scale_unit";
import { indexAt } from "../src/plots/index_at";
import { stepFrom } from "../src/plots/read_marks";
import { limitsOf } from "../src/sections/front";
import { ticks } from "../src/plots/ticks";

test("the best so far never rises and takes no infeasible point", () => {
  const objective = [3, 1, null, 2, 0.5, 2.5];
  const feasible = [true, false, true, true, false, true];
  const best = bestSoFar(objective, feasible);
  assert.deepEqual(best, [3, 3, 3, 2, 2, 2]);
  assert.deepEqual(bestSoFar([1, 2], [false, false]), [null, null]);
});

test("phases are counted as they follow each other", () => {
  const runs = phaseRuns({ phase: ["start", "sweep", "search"], of: [0, 1, 1, 2, 1] });
  assert.deepEqual(runs.map((run) => [run.phase, run.to - run.from + 1]), [["start", 1], ["sweep", 2], ["search", 1], ["sweep", 1]]);
});

test("what is not drawn is said", () => {
  assert.equal(undrawnText(0), "");
  assert.match(undrawnText(2), /^2 of them/);
});

test("of thinned evaluations numbers, counts and phases are those of all", () => {
  const few = { phase: ["start", "search"], of: [0, 1, 1], objective: [1, null, 2], feasible: [true, false, false], violation: [0, 1, 1], start: 0, chosen: 0 };
  assert.deepEqual(countsOf(few), { total: 3, feasible: 1, native: 0, undrawn: 1 });
  assert.equal(numberOf({}, 2), 2);
  const thinned = {
    number: [0, 40, 900], total: 1000, feasible: 300, native: 20, without_objective: 7,
    phase_runs: [{ phase: 0, from: 0, to: 0 }, { phase: 1, from: 1, to: 999 }], more_phase_runs: false,
  };
  const counts = countsOf({ ...few, thinned });
  assert.deepEqual([counts.total, counts.feasible, counts.native, counts.undrawn], [1000, 300, 20, 7]);
  assert.equal(numberOf({ thinned }, 2), 900);
  assert.deepEqual(phaseRuns({ ...few, thinned }), [{ phase: "start", from: 0, to: 0 }, { phase: "search", from: 1, to: 999 }]);
});

test("bounds are the ends of a gain's scale and the geometric mean is the middle of a logarithmic one", () => {
  for (const scale of ["log", "linear"] as const) {
    const gain = { lower: 2, upper: 32, scale };
    assert.equal(placeOnScale(gain, 2), 0);
    assert.equal(placeOnScale(gain, 32), 1);
    assert.equal(placeOnScale(gain, 1), 0);
    assert.equal(placeOnScale(gain, 50), 1);
    assert.ok(Math.abs(placeOnScale(gain, scale === "log" ? 8 : 17) - 0.5) < 1e-12);
  }
});

test("a logarithmic scale from zero on is drawn linear", () => {
  assert.equal(placeOnScale({ lower: 0, upper: 10, scale: "log" }, 5), 0.5);
});

test("a gain is at a bound only where it touches it", () => {
  const gain = { lower: 1, upper: 100, scale: "log" } as const;
  assert.equal(boundOf(gain, 1), "lower");
  assert.equal(boundOf(gain, 100), "upper");
  assert.equal(boundOf(gain, 1.1), "");
  assert.equal(boundOf({ lower: 0, upper: 1600, scale: "linear" }, 0.1), "");
});

test("scaled values and their unit name the same quantity", () => {
  assert.deepEqual(scaleUnit("m", 0.002), { factor: 1000, unit: "mm" });
  assert.deepEqual(scaleUnit("m", 0.2), { factor: 1, unit: "m" });
  assert.deepEqual(scaleUnit("N m", 0.002), { factor: 1, unit: "N m" });
  assert.deepEqual(scaleUnit("rad", 0), { factor: 1, unit: "rad" });
});

test("the index at a time is the last one not after it", () => {
  const x = [0, 0, 1, 1, 2, 5];
  for (const time of [-1, 0, 0.5, 1, 1.9, 2, 4, 5, 9]) {
    const i = indexAt(x, time);
    const slow = Math.max(0, x.filter((value) => value <= time).length - 1);
    assert.equal(i, slow, `time ${time}`);
  }
});

test("ticks are round, evenly spaced and inside", () => {
  for (const [lo, hi] of [[0, 1], [-0.3, 7.4], [1e-4, 3.3e-4], [0, 12345]] as const) {
    const made = ticks(lo, hi, 5);
    assert.ok(made.length >= 2 && made.length <= 7, `${lo} to ${hi}: ${made.length}`);
    const step = (made[1] ?? 0) - (made[0] ?? 0);
    made.forEach((tick, i) => {
      assert.ok(tick >= lo - 1e-9 * step && tick <= hi + 1e-9 * step);
      assert.ok(Math.abs(tick - ((made[0] ?? 0) + i * step)) < 1e-6 * step);
    });
    const mantissa = Number((step / 10 ** Math.floor(Math.log10(step * (1 + 1e-9)))).toFixed(6));
    assert.ok([1, 2, 5].includes(mantissa), `step ${step}`);
  }
});

test("the best so far is of what is not native, or of all where but the start all is", () => {
  const base = { phase: ["start", "search"], of: [0, 1, 1, 1], objective: [4, 1, 3, 2], feasible: [true, true, true, true], violation: [0, 0, 0, 0], start: 0, chosen: 2 };
  assert.deepEqual(bestLine(base).values, [4, 1, 1, 1]);
  const mixed = bestLine({ ...base, native: [false, true, false, true] });
  assert.deepEqual(mixed.values, [4, 1, 1, 1]);
  assert.match(mixed.label, /either engine/);
});

test("arrow keys meet every shown mark once and stop at the ends", () => {
  const shown = [false, true, false, true, true];
  const met: number[] = [];
  for (let at = stepFrom(shown, -1, 1), before = -1; at !== before; before = at, at = stepFrom(shown, at, 1)) met.push(at);
  assert.deepEqual(met, [1, 3, 4]);
  assert.equal(stepFrom(shown, -1, -1), 4);
  assert.equal(stepFrom(shown, 1, -1), 1);
  assert.equal(stepFrom([false, false], -1, 1), -1);
});

test("a limit that would leave the points no room is said and not drawn", () => {
  const point = (value: number) => ({ values: [value], label: "", feasible: true, role: "point" as const });
  const limits = [1.5, 2.9, 50].map((value) => ({ criterion: 0, value })).concat({ criterion: 1, value: 1 });
  assert.deepEqual(limitsOf({ points: [point(1), point(2)], limits }, 0), { near: [1.5, 2.9], far: [50] });
});
