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
    label: native ? "best feasible so far, of either engine" : "best feasible so far",
    values: bestSoFar(evaluations.objective, evaluations.feasible),
  };
}

/** What is said of evaluations that have no objective to draw: given up by the search, or never finished. */
export function undrawnText(objective: (number | null)[]): string {
  const count = objective.filter((value) => value === null).length;
  return count > 0 ? `${count} of them given up without an objective, not drawn` : "";
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
