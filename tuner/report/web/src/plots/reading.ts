// Computes the value of a curve at the playhead, for the legend.
import { formatNumber } from "../format";
import { indexAt } from "./index_at";

/** Returns the value at a time, interpolated linearly between the points of the run. Beside a gap it is the
 * nearer value. NaN in a gap and after the end of the run. */
export function valueAt(time: ArrayLike<number>, values: ArrayLike<number>, at: number, end: number): number {
  if (time.length === 0 || at > end) return NaN;
  const i = indexAt(time, at);
  const [from, to] = [time[i] ?? 0, time[i + 1] ?? time[i] ?? 0];
  const part = to > from ? Math.min(Math.max((at - from) / (to - from), 0), 1) : 0;
  const a = values[i] ?? NaN;
  const b = values[i + 1] ?? a;
  if (Number.isNaN(a) || Number.isNaN(b)) return part < 0.5 ? a : b;
  return a + part * (b - a);
}

/** Returns the value with three digits, but without digits below the step in which it was stored. */
export function formatReading(value: number, step: number): string {
  if (!(step > 0) || !Number.isFinite(value)) return formatNumber(value, 3);
  const place = 10 ** Math.ceil(Math.log10(step) - 1e-9);
  return formatNumber(Math.round(value / place) * place, 3);
}
