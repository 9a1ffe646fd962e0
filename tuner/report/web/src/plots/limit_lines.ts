// The limits of a plan as lines across a time plot: dashed where they hold, thick where they hold the plan back.
import type { PlanLimit } from "../data";
import { element } from "../dom";
import { formatNumber, shortName, withUnit } from "../format";
import type { Line } from "./backdrop";

/** A limit farther from zero than so many times the largest value is not drawn: it would press the curves flat. */
const IN_SIGHT = 3;

/** Of the largest value: labels that are closer lie over each other. */
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

/** limits: of one plot. largest: of the plot's values, in the limits' unit. colour: of a column's curve. Bounds that
 * several columns share are one dashed line; what is active has the colour of its own curve. */
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

/** "-1 to 2 rad", "at most 0.15 rad". */
export function boundWords({ lower, upper, unit }: Pick<PlanLimit, "lower" | "upper" | "unit">): string {
  if (lower === null) return `at most ${withUnit(formatNumber(upper, 3), unit)}`;
  if (upper === null) return `at least ${withUnit(formatNumber(lower, 3), unit)}`;
  if (lower === -upper) return `± ${withUnit(formatNumber(upper, 3), unit)}`;
  return withUnit(`${formatNumber(lower, 3)} to ${formatNumber(upper, 3)}`, unit);
}

/** What is not in the picture, said below it. */
export function farWords(far: PlanLimit[]): HTMLElement | null {
  if (far.length === 0) return null;
  const byWords = new Map<string, string[]>();
  for (const limit of far) byWords.set(boundWords(limit), [...(byWords.get(boundWords(limit)) ?? []), limit.part]);
  const parts = [...byWords].map(([words, names]) => `${words} (${names.join(", ")})`);
  return element("p", { class: "note far" }, `Limits outside the plot: ${parts.join("; ")}`);
}
