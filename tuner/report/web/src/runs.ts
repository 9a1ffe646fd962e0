// How long runs last, and how they end.
import type { Run, Scenario } from "./data";
import { formatNumber } from "./format";

/** s: when the last of a scenario's runs ended. Where none got off the ground, the scenario's duration: time needs a range. */
export function lastEnd(scenario: Pick<Scenario, "duration" | "runs">): number {
  const end = Math.max(0, ...scenario.runs.map((run) => run.end).filter(Number.isFinite));
  return end > 0 ? Math.min(end, scenario.duration) : scenario.duration;
}

/** Of a time axis: what its zero is, where the scenario's clock does not begin there. */
export function timeLabel(runs: Pick<Run, "start">[]): string {
  const start = Math.max(0, ...runs.map((run) => run.start));
  return start > 0 ? `time since ${formatNumber(start, 6)} s [s]` : "time [s]";
}

/** Whether the run has ended before its scenario did, and the time is not before that. */
export function isOver(run: Pick<Run, "status" | "end">, time: number): boolean {
  return run.status !== "completed" && time >= run.end;
}

/** "start: diverged at 4.206 s in followTrajectory: ..."; a reason says when. */
export function endOf(run: Pick<Run, "status" | "end" | "reason">, set: string): string {
  const why = run.reason === "" ? `${run.status === "" ? "ended" : run.status} at ${run.end.toFixed(3)} s` : run.reason;
  return set === "" ? why : `${set}: ${why}`;
}

/** Where a reader starts: the arm at work, since where a run begins it only unfolds; within the run that is shown. */
export function openingTime(run: Pick<Run, "end"> | undefined, duration: number): number {
  const FIRST_LOOK = 0.4;  // of the run
  const end = run === undefined || !Number.isFinite(run.end) ? duration : Math.min(run.end, duration);
  return FIRST_LOOK * Math.max(end, 0);
}

/** Why there is no replay, in words; empty where there is one. */
export function noReplay(run: Pick<Run, "replay">, hasRobot: boolean, set: string): string {
  if (!hasRobot) return "No replay: the run folder has no data about the arm.";
  return run.replay.n === 0 ? `No replay: the run folder has no joint positions of ${set === "" ? "this run" : set}.` : "";
}
