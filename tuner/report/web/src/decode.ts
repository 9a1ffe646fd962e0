// Decodes the series of the report data into numbers.
import type { Series } from "./data";

const NO_VALUE = 65535;
const STEPS = 65534;

export function decodeBase64(text: string): Uint8Array {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/** Returns the values; NaN for a missing value. */
export function decodeSeries(series: Series): Float64Array {
  const bytes = decodeBase64(series.u16);
  const view = new DataView(bytes.buffer);
  const n = bytes.length >> 1;
  const step = (series.hi - series.lo) / STEPS;
  const values = new Float64Array(n);
  for (let i = 0; i < n; ++i) {
    const code = view.getUint16(2 * i, true);
    values[i] = code === NO_VALUE ? NaN : series.lo + code * step;
  }
  return values;
}

/** Decodes little-endian float32 numbers. */
export function decodeFloats(text: string): Float32Array {
  const bytes = decodeBase64(text);
  const view = new DataView(bytes.buffer);
  const values = new Float32Array(bytes.length >> 2);
  for (let i = 0; i < values.length; ++i) values[i] = view.getFloat32(4 * i, true);
  return values;
}

/** Returns the value at a time, for values at the times i * dt. It is interpolated linearly; if one neighbour
 * is missing, it is the nearer one. */
export function sampleAt(values: ArrayLike<number>, dt: number, time: number): number {
  const last = values.length - 1;
  if (last < 0) return NaN;
  const x = Math.min(Math.max(time / dt, 0), last);
  const i = Math.min(Math.floor(x), Math.max(last - 1, 0));
  const a = values[i] ?? NaN;
  const b = values[Math.min(i + 1, last)] ?? NaN;
  const part = x - i;
  if (Number.isNaN(a) || Number.isNaN(b)) return part < 0.5 ? a : b;
  return a + part * (b - a);
}
