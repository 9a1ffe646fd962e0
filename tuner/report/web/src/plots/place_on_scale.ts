// Computes the position of a gain between its bounds.
import type { Gain } from "../data";

/** Returns 0 at the lower bound and 1 at the upper one, on the gain's scale. A log scale with a lower bound
 * of zero is replaced by a linear one. */
export function placeOnScale(gain: Pick<Gain, "lower" | "upper" | "scale">, value: number): number {
  const { lower, upper } = gain;
  const place =
    gain.scale === "log" && lower > 0 && value > 0
      ? Math.log(value / lower) / Math.log(upper / lower)
      : (value - lower) / (upper - lower);
  return Number.isFinite(place) ? Math.min(Math.max(place, 0), 1) : 0;
}

/** A gain closer to a bound than this share of the scale counts as at the bound. The share is smaller on a
 * linear scale, because many linear ranges begin at zero and span several decades. */
const NEAR = { log: 5e-3, linear: 1e-6 };

export function boundOf(gain: Pick<Gain, "lower" | "upper" | "scale">, value: number): "lower" | "upper" | "" {
  const place = placeOnScale(gain, value);
  if (place < NEAR[gain.scale]) return "lower";
  return place > 1 - NEAR[gain.scale] ? "upper" : "";
}
