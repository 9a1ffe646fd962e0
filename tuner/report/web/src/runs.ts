// Describes how long runs last, and how they end.
import type { Run, Scenario } from "./data";
import { formatNumber } from "./format";

/** Returns the time at which the last of the scenario's runs ended [s]. If all ended at once, returns the
 * duration of the scenario, because the time axis needs a range. */
export function lastEnd(scenario: Pick<Scenario, "duration" | "runs">): number {
  const end = Math.max(0, ...scenario.runs.map((run) => run.end).filter(Number.isFinite));
  return end > 0 ? Math.min(end, scenario.duration) : scenario.duration;
}

/** Returns the label of a time axis. It names the zero of the axis if this is not time 0 of the scenario. */
export function timeLabel(runs: Pick<Run, "start">[]): string {
  const start = Math.max(0, ...runs.map((run) => run.start));
  return start > 0 ? `time since ${formatNumber(start, 6)} s [s]` : "time [s]";
}

/** True if the run ended early, and the time is at or after its end. */
export function isOver(run: Pick<Run, "status" | "end">, time: number): boolean {
  return run.status !== "completed" && time >= run.end;
}

/** Returns, for example, "start: diverged at 4.206 s in followTrajectory: ...". `reason` includes the time.
 * */
export function endOf(run: Pick<Run, "status" | "end" | "reason">, set: string): string {
  const why = run.reason === "" ? `${run.status === "" ? "ended" : run.status} at ${run.end.toFixed(3)} s` : run.reason;
  return set === "" ? why : `${set}: ${why}`;
}

/** Returns the time that is shown first. It is after the beginning, where the arm only moves to its path, and
 * within the shown run. */
export function openingTime(run: Pick<Run, "end"> | undefined, duration: number): number {
  const FIRST_LOOK = 0.4;  // share of the run
  const end = run === undefined || !Number.isFinite(run.end) ? duration : Math.min(run.end, duration);
  return FIRST_LOOK * Math.max(end, 0);
}

/** Returns why there is no replay; empty if there is one. */
export function noReplay(run: Pick<Run, "replay">, hasRobot: boolean, set: string): string {
  if (!hasRobot) return "No replay: the run folder has no data about the arm.";
  return run.replay.n === 0 ? `No replay: the run folder has no joint positions of ${set === "" ? "this run" : set}.` : "";
}
