import assert from "node:assert/strict";
import { test } from "node:test";
import { decodeFloats, decodeSeries, sampleAt } from "../src/decode";

/** Encodes as the contract in data.ts says, written here a second time from its words. */
function encode(values: number[], lo: number, hi: number) {
  const bytes = Buffer.alloc(2 * values.length);
  values.forEach((value, i) => {
    const code = Number.isNaN(value) ? 65535 : hi > lo ? Math.round(((value - lo) / (hi - lo)) * 65534) : 0;
    bytes.writeUInt16LE(code, 2 * i);
  });
  return { lo, hi, u16: bytes.toString("base64") };
}

test("a series comes back within half a step", () => {
  const values = Array.from({ length: 1000 }, (_, i) => -3 + 8 * Math.sin(i) ** 2);
  const decoded = decodeSeries(encode(values, -3, 5));
  // Rounding to the nearest of 65535 levels, and the last bits of the arithmetic.
  const half = (8 / 65534) * 0.5 * (1 + 1e-9);
  values.forEach((value, i) => assert.ok(Math.abs(value - (decoded[i] ?? NaN)) <= half, `value ${i}`));
});

test("both ends of a series come back as they are", () => {
  const decoded = decodeSeries(encode([0.1, 7.3], 0.1, 7.3));
  assert.equal(decoded[0], 0.1);
  assert.ok(Math.abs((decoded[1] ?? 0) - 7.3) <= 1e-15 * 7.3 * 4);
});

test("a missing value is NaN and moves no other", () => {
  const decoded = decodeSeries(encode([1, NaN, 2], 1, 2));
  assert.ok(Number.isNaN(decoded[1]));
  assert.equal(decoded[0], 1);
  assert.equal(decoded[2], 2);
});

test("a constant series is its value", () => {
  assert.deepEqual([...decodeSeries(encode([4.25, 4.25, NaN], 4.25, 4.25)).slice(0, 2)], [4.25, 4.25]);
});

test("an empty series has no points", () => {
  assert.equal(decodeSeries({ lo: 0, hi: 0, u16: "" }).length, 0);
});

test("floats of a mesh are little-endian", () => {
  const bytes = Buffer.alloc(8);
  bytes.writeFloatLE(-1.5, 0);
  bytes.writeFloatLE(1024.25, 4);
  assert.deepEqual([...decodeFloats(bytes.toString("base64"))], [-1.5, 1024.25]);
});

test("samples are met exactly and lines between them are straight", () => {
  const values = [0, 10, 30];
  assert.equal(sampleAt(values, 0.5, 0.5), 10);
  assert.ok(Math.abs(sampleAt(values, 0.5, 0.75) - 20) < 1e-12);
});

test("before the first and after the last sample the value stays", () => {
  assert.equal(sampleAt([3, 5], 1, -2), 3);
  assert.equal(sampleAt([3, 5], 1, 9), 5);
  assert.equal(sampleAt([3], 1, 0.7), 3);
  assert.ok(Number.isNaN(sampleAt([], 1, 0)));
});

test("a missing sample does not spoil its neighbour", () => {
  assert.equal(sampleAt([2, NaN], 1, 0.4), 2);
  assert.ok(Number.isNaN(sampleAt([2, NaN], 1, 0.6)));
});
