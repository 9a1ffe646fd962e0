import assert from "node:assert/strict";
import { test } from "node:test";
import { errorAt } from "../src/sections/validation";

test("the error after a time is that of the nearest horizon, and none beyond the last one", () => {
  const horizons = Array.from({ length: 51 }, (_, i) => 0.02 * i);
  const errors = horizons.map((time) => 3 * time);
  for (const time of [0.1, 0.5, 1]) assert.ok(Math.abs((errorAt(horizons, errors, time) ?? NaN) - 3 * time) < 1e-9);
  assert.equal(errorAt(horizons, errors, 2), null);
  assert.equal(errorAt([], [], 1), null);
  assert.equal(errorAt(horizons, errors.map(() => null), 0.5), null);
});
