// Formats numbers and names as text.

const NONE = "–";

/** Returns the number with four significant digits; very large and very small ones have a power of ten. */
export function formatNumber(value: number | null | undefined, digits = 4): string {
  if (value === null || value === undefined || Number.isNaN(value)) return NONE;
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "−∞";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const text =
    size >= 1e6 || size < 1e-4
      ? value.toExponential(digits - 1).replace(/\.?0+e/, "e").replace("e+", "e")
      : trimZeros(value.toPrecision(digits));
  return text.replace(/-/g, "−");
}

function trimZeros(text: string): string {
  if (text.includes("e")) return String(Number(text));
  return text.includes(".") ? text.replace(/\.?0+$/, "") : text;
}

const RAISED: Record<string, string> = { "-": "⁻", "1": "¹", "2": "²", "3": "³", "4": "⁴" };

/** Returns the unit with raised powers, such as m/s² for m/s^2; empty for "1", the unit of pure numbers. */
export function formatUnit(unit: string): string {
  if (unit === "1") return "";
  return unit.replace(/\^(-?[1-4])(?!\d)/g, (_, power: string) => [...power].map((c) => RAISED[c] ?? c).join(""));
}

export function withUnit(text: string, unit: string): string {
  const shown = formatUnit(unit);
  return shown === "" ? text : `${text} ${shown}`;
}

export function formatValue(value: number | null | undefined, unit: string): string {
  const text = formatNumber(value);
  return text === NONE ? text : withUnit(text, unit);
}

/** Returns after / before; null if it has no meaning (a value is missing, or `before` is zero or has the
 * other sign). */
export function ratioOf(before: number | null | undefined, after: number | null | undefined): number | null {
  if (before === null || before === undefined || after === null || after === undefined) return null;
  if (before === 0 || before < 0 !== after < 0) return before === after && before !== 0 ? 1 : null;
  return after / before;
}

export function formatRatio(ratio: number | null): string {
  if (ratio === null) return NONE;
  return `× ${ratio >= 100 ? formatNumber(ratio, 3) : ratio.toFixed(ratio < 0.1 ? 3 : 2)}`;
}

export type Change = "better" | "worse" | "same" | "none";

/** Returns the kind of a change. Half a percent up or down counts as the same, because it is not visible in
 * three digits. */
export function changeOf(
  before: number | null | undefined,
  after: number | null | undefined,
  better: "lower" | "higher" | undefined,
): Change {
  if (before === null || before === undefined || after === null || after === undefined) return "none";
  if (better === undefined) return "none";
  const scale = Math.max(Math.abs(before), Math.abs(after));
  if (Math.abs(after - before) <= 0.005 * scale) return "same";
  return after < before === (better === "lower") ? "better" : "worse";
}

/** Returns the time with a fixed number of decimals. If the whole run is short, these are milliseconds. */
export function formatTime(seconds: number, whole = 10): string {
  return `${seconds.toFixed(whole < 2 ? 3 : 2)} s`;
}

/** Returns a duration such as "40 s", "12 min" or "3.5 h". */
export function duration(seconds: number): string {
  if (seconds < 90) return `${Math.ceil(seconds)} s`;
  if (seconds < 5400) return `${Math.ceil(seconds / 60)} min`;
  return `${(seconds / 3600).toFixed(1)} h`;
}

export function formatPercent(portion: number, digits = 1): string {
  return `${(100 * portion).toFixed(digits)} %`;
}

/** Keeps each number and its unit on one line. */
export function unbroken(sentence: string): string {
  return sentence.replace(/(\d) (?=(%|mm|deg|s)(?![\w]))/g, "$1\u00a0");
}

/** Returns the joint in a column name such as joint/elbow_joint/velocity; for other names, the part after the
 * last slash. */
export function shortName(column: string): string {
  const parts = column.split("/");
  if (parts[0] === "joint" && parts.length >= 3) return parts.slice(1, -1).join("/");
  return parts[parts.length - 1] ?? column;
}

/** Returns a file name made from the parts. Characters that may not be allowed become _. */
export function fileName(...parts: string[]): string {
  return parts.map((part) => part.replace(/[^A-Za-z0-9_.-]+/g, "_")).filter((part) => part !== "").join("-");
}
