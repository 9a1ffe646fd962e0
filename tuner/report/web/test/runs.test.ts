import assert from "node:assert/strict";
import { test } from "node:test";
import type { Replay, Run } from "../src/data";
import { endOf, isOver, lastEnd, noReplay, openingTime, timeLabel } from "../src/runs";

function run(end: number, status = "completed", reason = ""): Run {
  const constant = { lo: 0, hi: 0, u16: "" };
  const replay: Replay = { dt: 0.04, n: 2, q: [], target: [], obstacles: [], cell: [], closest: [], tool: [], error: constant, velocity_ratio: [] };
  return { set: 0, status, reason, start: 0, end, states: [], slerps: [], time: constant, columns: [], replay };
}

test("time ends with the last of the runs, not with the scenario", () => {
  assert.equal(lastEnd({ duration: 10, runs: [run(4.2, "diverged"), run(3)] }), 4.2);
  assert.equal(lastEnd({ duration: 10, runs: [run(4.2, "diverged"), run(10)] }), 10);
});

test("time has a range even where no run got off the ground", () => {
  assert.equal(lastEnd({ duration: 10, runs: [run(0, "diverged")] }), 10);
  assert.equal(lastEnd({ duration: 10, runs: [] }), 10);
});

test("only a run that did not complete is over", () => {
  assert.equal(isOver(run(4.2, "diverged"), 4.1), false);
  assert.equal(isOver(run(4.2, "diverged"), 4.2), true);
  assert.equal(isOver(run(10), 10), false);
});

test("a reader starts within the run that is shown", () => {
  for (const end of [0, 0.3, 4.2, 10]) {
    const opening = openingTime(run(end, "diverged"), 10);
    assert.ok(opening >= 0 && opening <= end, `${opening} of ${end}`);
  }
  assert.ok(openingTime(undefined, 10) <= 10);
});

test("if the times of a run do not begin at zero, the time axis names the first", () => {
  assert.equal(timeLabel([run(10)]), "time [s]");
  assert.equal(timeLabel([]), "time [s]");
  assert.equal(timeLabel([{ start: 8.25 }]), "time since 8.25 s [s]");
});

test("an end is said with its time and its reason, or else its status", () => {
  assert.equal(endOf(run(4.2061, "diverged", "diverged at 4.208 s: why"), "tuned"), "tuned: diverged at 4.208 s: why");
  assert.equal(endOf(run(4.2, "diverged"), ""), "diverged at 4.200 s");
});

test("words stand only where there is no replay", () => {
  const without = run(10);
  without.replay.n = 0;
  assert.equal(noReplay(run(10), true, "tuned"), "");
  assert.match(noReplay(run(10), false, "tuned"), /about the arm/);
  assert.match(noReplay(without, true, "tuned"), /of tuned/);
});
