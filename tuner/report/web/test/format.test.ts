import assert from "node:assert/strict";
import { test } from "node:test";
import { changeOf, duration, fileName, formatNumber, formatRatio, formatUnit, formatValue, ratioOf, shortName, unbroken } from "../src/format";

test("a number reads back within its digits", () => {
  for (const value of [0.001909, 0.7662, 5134.2, 1.856, 12, 1e-7, 4.2e9, 123456, -0.3, -7e-9]) {
    const text = formatNumber(value).replace(/−/g, "-");
    assert.ok(Math.abs(Number(text) - value) <= 0.5e-3 * Math.abs(value), `${value} became ${text}`);
  }
});

test("zeros at the end go, those in front of the point stay", () => {
  assert.equal(formatNumber(1.5), "1.5");
  assert.equal(formatNumber(200), "200");
  assert.equal(formatNumber(10), "10");
  assert.equal(formatNumber(0), "0");
});

test("what is not a number is a dash or an infinity", () => {
  assert.equal(formatNumber(null), "–");
  assert.equal(formatNumber(undefined), "–");
  assert.equal(formatNumber(NaN), "–");
  assert.equal(formatNumber(-Infinity), "−∞");
});

test("the unit of a pure number is not written", () => {
  assert.equal(formatValue(2, "1"), "2");
  assert.equal(formatValue(2, "rad/s"), "2 rad/s");
  assert.equal(formatValue(null, "rad/s"), "–");
});

test("powers in units are raised", () => {
  assert.equal(formatUnit("1/s^2"), "1/s²");
  assert.equal(formatUnit("kg m^-1"), "kg m⁻¹");
  assert.equal(formatUnit("1"), "");
});

test("a ratio exists where it means something", () => {
  assert.equal(ratioOf(4, 2), 0.5);
  assert.equal(ratioOf(0, 2), null);
  assert.equal(ratioOf(null, 2), null);
  assert.equal(ratioOf(-1, 2), null);
  assert.equal(ratioOf(-2, -1), 0.5);
  assert.equal(formatRatio(null), "–");
  assert.equal(formatRatio(0.5), "× 0.50");
});

test("what is better depends on the metric's direction", () => {
  assert.equal(changeOf(2, 1, "lower"), "better");
  assert.equal(changeOf(2, 1, "higher"), "worse");
  assert.equal(changeOf(1, 2, "lower"), "worse");
  assert.equal(changeOf(-2, -1, "higher"), "better");
  assert.equal(changeOf(1, 1.001, "lower"), "same");
  assert.equal(changeOf(0, 0, "lower"), "same");
  assert.equal(changeOf(1, 2, undefined), "none");
  assert.equal(changeOf(null, 2, "lower"), "none");
});

test("a column's short name is its axis or its joint", () => {
  assert.equal(shortName("error/position/x"), "x");
  assert.equal(shortName("joint/elbow_joint/velocity_ratio"), "elbow_joint");
  assert.equal(shortName("manipulability"), "manipulability");
});

test("file names hold nothing but plain characters", () => {
  assert.match(fileName("<script>a/b</script>", "x y"), /^[A-Za-z0-9_.-]+$/);
  assert.equal(fileName("a", "", "b"), "a-b");
});

test("a number keeps its unit beside it, and words their spaces", () => {
  assert.equal(unbroken("falls by 26 %; 3 joints, 2.5 mm at 2.01 s so far"), "falls by 26\u00a0%; 3 joints, 2.5\u00a0mm at 2.01\u00a0s so far");
});

test("a wait is said in the unit that a person would use, and not too short", () => {
  assert.equal(duration(0.2), "1 s");
  assert.equal(duration(89), "89 s");
  assert.equal(duration(90), "2 min");
  assert.equal(duration(3601), "61 min");
  assert.equal(duration(12600), "3.5 h");
});
