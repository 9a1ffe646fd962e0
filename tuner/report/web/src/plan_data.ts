// The part of the contract that data.ts states which plans alone have.
import type { Group } from "./run_data";

/** A limit of one joint or axis that a plan keeps. Times from the plan's start, s. */
export interface PlanLimit {
  /** "velocity", "torque", "gaze" ... */
  limit: string;
  /** The joint or axis. */
  part: string;
  /** Both: "torque of elbow_joint", "gaze". */
  words: string;
  unit: string;
  /** null: none on this side. */
  lower: number | null;
  upper: number | null;
  /** When it holds. */
  from: number;
  to: number;
  /** Largest share of it that is used, 1 at the limit: at the plan's knots, and between them where it is not enforced. */
  at_knots: number | null;
  between_knots: number | null;
  /** Share of the knots at which it holds the plan back. */
  active: number;
  /** Sum of its multipliers: s, or cost, per unit of relief; 0 where it does not. */
  strength: number;
  active_lower: [number, number][];
  active_upper: [number, number][];
  /** Where it is drawn: plot and column. */
  group: Group;
  column: string;
}

/** What a plan is and how well it was solved, beside its limits, which stand with the one scenario. */
export interface Plan {
  /** When it begins on its scenario's time, s; the page counts from there. */
  start: number;
  scenario: string;
  /** Name and value: knots, violation, residuals ... */
  figures: [string, string][];
}
