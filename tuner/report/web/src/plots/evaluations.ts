// Computes the data for the plot of a search.
import type { Evaluations } from "../data";

/** Returns, for each evaluation, the smallest objective of a feasible one so far; null before the first. */
export function bestSoFar(objective: (number | null)[], feasible: boolean[]): (number | null)[] {
  let best: number | null = null;
  return objective.map((value, i) => {
    if (feasible[i] === true && value !== null && (best === null || value < best)) best = value;
    return best;
  });
}

/** Returns the line of the best objective so far, and its label. It includes evaluations in the native
 * engine, although Simbody judges the result. */
export function bestLine(evaluations: Evaluations): { label: string; values: (number | null)[] } {
  const native = evaluations.native?.includes(true) === true;
  return {
    label: native ? "best feasible so far, in either engine" : "best feasible so far",
    values: bestSoFar(evaluations.objective, evaluations.feasible),
  };
}

/** Returns the number of an evaluation among all evaluations. */
export function numberOf(evaluations: Pick<Evaluations, "thinned">, i: number): number {
  return evaluations.thinned?.number[i] ?? i;
}

export interface Counts {
  total: number;
  feasible: number;
  native: number;
  undrawn: number;
}

/** Returns the counts of all evaluations, even if the page shows only some of them. */
export function countsOf(evaluations: Evaluations): Counts {
  const { objective, feasible, native, thinned } = evaluations;
  if (thinned !== undefined) return { ...thinned, undrawn: thinned.without_objective };
  return {
    total: objective.length,
    feasible: feasible.filter(Boolean).length,
    native: (native ?? []).filter(Boolean).length,
    undrawn: objective.filter((value) => value === null).length,
  };
}

/** Returns a note on evaluations without an objective; empty if there are none. Earlier versions of armtune
 * abandoned some evaluations. */
export function undrawnText(count: number): string {
  return count > 0 ? `${count} of them without an objective, not drawn` : "";
}

export interface PhaseRun {
  phase: string;
  /** Numbers of its first and its last evaluation. */
  from: number;
  to: number;
}

/** Returns the groups of consecutive evaluations of one phase. */
export function phaseRuns(evaluations: Pick<Evaluations, "phase" | "of" | "thinned">): PhaseRun[] {
  const { thinned } = evaluations;
  if (thinned !== undefined)
    return thinned.phase_runs.map(({ phase, from, to }) => ({ phase: evaluations.phase[phase] ?? "", from, to }));
  const runs: PhaseRun[] = [];
  evaluations.of.forEach((index, i) => {
    const phase = evaluations.phase[index] ?? "";
    const last = runs[runs.length - 1];
    if (last !== undefined && last.phase === phase) last.to = i;
    else runs.push({ phase, from: i, to: i });
  });
  return runs;
}
