// What a legend says of a line at the playhead.
import { formatNumber } from "../format";
import { indexAt } from "./index_at";

/** On the run's own time axis, straight between its points as it is drawn; the nearer one beside a gap. NaN in a gap
 * and after the run's end. */
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

/** Three digits, and none below the step in which the value was stored. */
export function formatReading(value: number, step: number): string {
  if (!(step > 0) || !Number.isFinite(value)) return formatNumber(value, 3);
  const place = 10 ** Math.ceil(Math.log10(step) - 1e-9);
  return formatNumber(Math.round(value / place) * place, 3);
}
