// What the plot of a search is made from.
import type { Evaluations } from "../data";

/** The smallest objective of a feasible evaluation up to each one; null before the first. */
export function bestSoFar(objective: (number | null)[], feasible: boolean[]): (number | null)[] {
  let best: number | null = null;
  return objective.map((value, i) => {
    if (feasible[i] === true && value !== null && (best === null || value < best)) best = value;
    return best;
  });
}

/** The line of the best, and what it is of: the native engine's evaluations are the search's way, though none of them is
 * what a run is judged by. */
export function bestLine(evaluations: Evaluations): { label: string; values: (number | null)[] } {
  const native = evaluations.native?.includes(true) === true;
  return {
    label: native ? "best feasible so far, in either engine" : "best feasible so far",
    values: bestSoFar(evaluations.objective, evaluations.feasible),
  };
}

/** What an evaluation is called: its place among all. */
export function numberOf(evaluations: Pick<Evaluations, "thinned">, i: number): number {
  return evaluations.thinned?.number[i] ?? i;
}

export interface Counts {
  total: number;
  feasible: number;
  native: number;
  undrawn: number;
}

/** Of all evaluations, also where the page shows some of them only. */
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

/** What is said of evaluations that have no objective to draw: an earlier version of armtune gave some up. */
export function undrawnText(count: number): string {
  return count > 0 ? `${count} of them without an objective, not drawn` : "";
}

export interface PhaseRun {
  phase: string;
  /** Numbers of its first and its last evaluation. */
  from: number;
  to: number;
}

/** Evaluations of one phase that follow each other. */
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
