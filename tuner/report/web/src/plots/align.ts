// Puts the runs of one scenario on one time axis.
import uPlot from "uplot";

export type Values = (number | null | undefined)[];

export interface TimedColumns {
  time: Float64Array;
  columns: Float64Array[];
}

/** Returns the values times a factor. NaN becomes null, a gap in the curve. */
export function gaps(values: ArrayLike<number>, factor = 1): Values {
  return Array.from({ length: values.length }, (_, i) => {
    const value = values[i] ?? NaN;
    return Number.isFinite(value) ? value * factor : null;
  });
}

function same(a: Float64Array, b: Float64Array): boolean {
  return a.length === b.length && a.every((value, i) => value === b[i]);
}

/** Returns one x axis for all runs. If a run has no point at an x, its value there is undefined. The curve
 * continues there, unlike at a gap. */
export function alignRuns(runs: TimedColumns[], factor: number): { x: number[]; columns: Values[] } {
  const first = runs[0];
  if (first === undefined) return { x: [], columns: [] };
  if (runs.every((run) => same(run.time, first.time))) {
    return { x: Array.from(first.time), columns: runs.flatMap((run) => run.columns.map((c) => gaps(c, factor))) };
  }
  // uPlot's join keeps only one point per x. Points at equal x are therefore shifted by half a nanosecond.
  const tables = runs.map((run) => {
    const x = Array.from(run.time);
    for (let i = 1; i < x.length; ++i) if ((x[i] ?? 0) <= (x[i - 1] ?? 0)) x[i] = (x[i - 1] ?? 0) + 5e-10;
    return [x, ...run.columns.map((column) => gaps(column, factor))] as uPlot.AlignedData;
  });
  const [x, ...columns] = uPlot.join(tables);
  return { x: Array.from(x as ArrayLike<number>), columns: columns as Values[] };
}
