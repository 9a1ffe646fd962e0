// The part of the contract that data.ts states which is one run: its plots and its replay.

/** One column, thinned and quantised. `u16`: base64 of little-endian uint16, 0..65534 linear from lo to hi,
 * 65535 = no value (not finite). lo = hi for a constant. */
export interface Series {
  lo: number;
  hi: number;
  u16: string;
}

export type Group =
  | "position"
  | "position_error"
  | "orientation_error"
  | "linear_velocity_error"
  | "angular_velocity_error"
  | "gaze"
  | "velocity_ratio"
  | "torque_ratio"
  | "joint_error"
  | "theta"
  | "clearance"
  | "manipulability"
  | `${"joint" | "slide"}_${"position" | "velocity" | "acceleration" | "jerk" | "torque"}`;

export interface Column {
  /** As in rollout_*.csv, such as error/position/x or joint/elbow_joint/velocity_ratio. */
  name: string;
  group: Group;
  unit: string;
  /** As many points as the run's `time`. */
  series: Series;
}

/** Sampled evenly in time: point i is at i * dt. All series have n points; n is 0 where the run has no replay. */
export interface Replay {
  dt: number;
  n: number;
  /** Per joint, rad or m. */
  q: Series[];
  /** x, y, z of the active target in the base frame; empty without one. */
  target: Series[];
  /** Per obstacle: x, y, z of its centre. */
  obstacles: Series[][];
  /** x, y, z of the tool. */
  tool: Series[];
  /** Norm of the position error, m; no value where the state tracks no position. So it is with the columns. */
  error: Series;
  /** Per joint, |velocity| over its limit: the largest within dt / 2 of the sample, so that no peak is missed. */
  velocity_ratio: Series[];
}

export interface Run {
  /** Index into `sets`. */
  set: number;
  status: string;
  /** When, where and why it ended, of what did not complete. */
  reason: string;
  /** What the scenario's clock began with, s: 0, or the time at which a planned trajectory begins. All other times
   * of the run are since then. */
  start: number;
  /** When it ended, s: before the scenario's duration, unless it completed. */
  end: number;
  /** Changes, in order; state: index into the scenario's `states`. */
  states: { t: number; state: number }[];
  /** Begin and end of every slerp, s. */
  slerps: [number, number][];
  /** s, not decreasing. Two points per bucket (the smallest and the largest of each column, in order of time), or
   * every sample of a short run. */
  time: Series;
  columns: Column[];
  replay: Replay;
}
