// What the plot of a search is made from.
import type { Evaluations } from "../data";

/** The smallest objective of a feasible evaluation that counts up to each one; null before the first. */
export function bestSoFar(
  objective: (number | null)[],
  feasible: boolean[],
  counts: (i: number) => boolean = () => true,
): (number | null)[] {
  let best: number | null = null;
  return objective.map((value, i) => {
    if (feasible[i] === true && value !== null && counts(i) && (best === null || value < best)) best = value;
    return best;
  });
}

/** The line of the best, and what it is of. Native evaluations are not what a run is judged by: they count only where,
 * but for the start, there are no others. */
export function bestLine(evaluations: Evaluations): { label: string; values: (number | null)[] } {
  const { objective, feasible, native, start } = evaluations;
  if (native === undefined || !native.includes(true)) {
    return { label: "best feasible so far", values: bestSoFar(objective, feasible) };
  }
  const others = native.some((one, i) => !one && i !== start);
  return others
    ? { label: "best feasible so far in Simbody", values: bestSoFar(objective, feasible, (i) => native[i] !== true) }
    : { label: "best feasible so far, native ones too", values: bestSoFar(objective, feasible) };
}

/** Evaluations of one phase that follow each other. */
export function phaseRuns(evaluations: Pick<Evaluations, "phase" | "of">): { phase: string; from: number; to: number }[] {
  const runs: { phase: string; from: number; to: number }[] = [];
  evaluations.of.forEach((index, i) => {
    const phase = evaluations.phase[index] ?? "";
    const last = runs[runs.length - 1];
    if (last !== undefined && last.phase === phase) last.to = i;
    else runs.push({ phase, from: i, to: i });
  });
  return runs;
}
