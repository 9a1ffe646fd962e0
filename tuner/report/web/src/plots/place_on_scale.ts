// Where a gain stands between its bounds.
import type { Gain } from "../data";

/** 0 at the lower bound, 1 at the upper, in the gain's own scale; linear where a logarithm has no lower end. */
export function placeOnScale(gain: Pick<Gain, "lower" | "upper" | "scale">, value: number): number {
  const { lower, upper } = gain;
  const place =
    gain.scale === "log" && lower > 0 && value > 0
      ? Math.log(value / lower) / Math.log(upper / lower)
      : (value - lower) / (upper - lower);
  return Number.isFinite(place) ? Math.min(Math.max(place, 0), 1) : 0;
}

/** Closer to a bound than this part of the scale, a search may have wanted to go on. Where the scale is linear a small
 * gain is not yet one at its bound: many have a range of several decades from zero on. */
const NEAR = { log: 5e-3, linear: 1e-6 };

export function boundOf(gain: Pick<Gain, "lower" | "upper" | "scale">, value: number): "lower" | "upper" | "" {
  const place = placeOnScale(gain, value);
  if (place < NEAR[gain.scale]) return "lower";
  return place > 1 - NEAR[gain.scale] ? "upper" : "";
}
