// Draws the limits of a plan as lines across a time plot: dashed while a limit applies, thick while it is
// active.
import type { PlanLimit } from "../data";
import { element } from "../dom";
import { formatNumber, shortName, withUnit } from "../format";
import type { Line } from "./backdrop";

/** An inactive limit farther from zero than this factor times the largest value is not drawn, because the
 * curves would become flat. */
const IN_SIGHT = 3;

/** Smallest distance of two labels, relative to the largest value; closer ones would overlap. */
const LABEL_ROOM = 0.2;

export interface LimitPicture {
  lines: Line[];
  /** Limits with a bound that is too far away to be drawn. */
  far: PlanLimit[];
}

interface Bound {
  limit: PlanLimit;
  value: number;
  upper: boolean;
  active: [number, number][];
}

function boundsOf(limit: PlanLimit): Bound[] {
  const bounds: Bound[] = [];
  if (limit.lower !== null) bounds.push({ limit, value: limit.lower, upper: false, active: limit.active_lower });
  if (limit.upper !== null) bounds.push({ limit, value: limit.upper, upper: true, active: limit.active_upper });
  return bounds;
}

/** Returns the lines of the limits of one plot. Columns with the same bound share one dashed line. While a
 * bound is active, its line has the colour of its own curve. largest: largest value of the plot, in the unit
 * of the limits; colour: returns the colour of a column's curve. */
export function limitLines(limits: PlanLimit[], largest: number, factor: number, colour: (column: string) => string): LimitPicture {
  const lines: Line[] = [];
  const far = new Set<PlanLimit>();
  const shared = new Map<string, Bound[]>();
  for (const bound of limits.flatMap(boundsOf)) {
    if (bound.active.length === 0 && Math.abs(bound.value) > IN_SIGHT * largest) {
      far.add(bound.limit);
      continue;
    }
    const key = [bound.value, bound.limit.from, bound.limit.to].join(" ");
    shared.set(key, [...(shared.get(key) ?? []), bound]);
  }
  const labelled: number[] = [];
  for (const bounds of shared.values()) {
    const first = bounds[0];
    if (first === undefined) continue;
    const columns = new Set(bounds.map((bound) => bound.limit.column));
    const all = new Set(limits.map((limit) => limit.column)).size === columns.size;
    const names = [...columns].map(shortName);
    const label = all ? "limit" : names.length === 1 ? `limit of ${names[0] ?? ""}` : `limit of ${names.length} joints`;
    const covered = labelled.some((value) => Math.abs(value - first.value) < LABEL_ROOM * largest);
    if (!covered) labelled.push(first.value);
    const line: Line = { value: first.value * factor, label: covered ? "" : label, from: first.limit.from, to: first.limit.to };
    if (!all && columns.size === 1) line.colour = colour(first.limit.column);
    lines.push(line);
    for (const bound of bounds) {
      for (const [from, to] of bound.active) {
        lines.push({ value: bound.value * factor, label: "", from, to, thick: true, colour: colour(bound.limit.column) });
      }
    }
  }
  return { lines, far: [...far] };
}

/** Returns, for example, "-1 to 2 rad" or "at most 0.15 rad". */
export function boundWords({ lower, upper, unit }: Pick<PlanLimit, "lower" | "upper" | "unit">): string {
  if (lower === null) return `at most ${withUnit(formatNumber(upper, 3), unit)}`;
  if (upper === null) return `at least ${withUnit(formatNumber(lower, 3), unit)}`;
  if (lower === -upper) return `± ${withUnit(formatNumber(upper, 3), unit)}`;
  return withUnit(`${formatNumber(lower, 3)} to ${formatNumber(upper, 3)}`, unit);
}

/** Returns a note on the limits that are not drawn, or null if there are none. */
export function farWords(far: PlanLimit[]): HTMLElement | null {
  if (far.length === 0) return null;
  const byWords = new Map<string, string[]>();
  for (const limit of far) byWords.set(boundWords(limit), [...(byWords.get(boundWords(limit)) ?? []), limit.part]);
  const parts = [...byWords].map(([words, names]) => `${words} (${names.join(", ")})`);
  return element("p", { class: "note far" }, `Limits outside the plot: ${parts.join("; ")}`);
}
