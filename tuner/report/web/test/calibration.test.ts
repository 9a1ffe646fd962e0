import assert from "node:assert/strict";
import { test } from "node:test";
import { cellsOf } from "../src/sections/calibration";

const told = { name: "delay", unit: "s", before: 0, after: 0.004, low: 0.003, high: 0.005, told: true, kept: false };

test("a parameter that the log tells shows its value and interval", () => {
  assert.deepEqual(cellsOf(told), ["0", "0.004", "0.003 to 0.005", "yes"]);
});

test("no value is claimed for a parameter that keeps that of the robot file, and the missing motion is named", () => {
  const cells = cellsOf({ ...told, told: false, kept: true, motion: "commands change fast" });
  assert.ok(!cells.includes("0.004"));
  assert.ok(cells.at(-1)?.startsWith("no") && cells.at(-1)?.endsWith("commands change fast"));
});
