// What the program writes into a report page: the contract between tuner/report and this folder. Written as one
// JSON object into <script id="report-data" type="application/json">. SI units; a unit stands beside every number
// that is shown. Any string is data and is shown as it is: markup in a name is never run. A part that is left
// out leaves its section out.

import type { Plan, PlanLimit } from "./plan_data";
import type { Column, Group, Replay, Run, Series } from "./run_data";

export type { Column, Group, Plan, PlanLimit, Replay, Run, Series };

export type Vec3 = [number, number, number];
/** w, x, y, z. */
export type Quaternion = [number, number, number, number];

export interface MetricRow {
  metric: string;
  unit: string;
  /** As a sentence has it: "largest position error". */
  words: string;
  meaning: string;
  /** One per set; null where there is none. */
  values: (number | null)[];
  /** One per set: what stands behind the number, such as the joint and the time of a ratio. */
  text?: string[];
  /** Which direction is an improvement; without it neither is coloured. */
  better?: "lower" | "higher";
}

/** Numbers of one scenario, one value per set. */
export interface Table {
  scenario: string;
  rows: MetricRow[];
  /** One per set: "completed", "diverged" ..., empty where there is none. */
  status: string[];
  /** One per set: when, where and why it ended, of what did not complete. */
  reason: string[];
}

/** What a study on many arms was judged by, where the other tables are of the nominal arm alone. */
export interface Judged {
  /** "worst of 5 arms each". */
  measure: string;
  tables: Table[];
}

export interface Joint {
  name: string;
  kind: "revolute" | "prismatic";
  /** Frame of the joint in the previous joint's frame (the base for the first) at q = 0, m. The joint turns about
   * or moves along its own z. */
  p: Vec3;
  q: Quaternion;
  /** rad/s or m/s. */
  velocity_limit: number;
  /** N m or N. */
  effort_limit: number;
  lower: number | null;
  upper: number | null;
}

export interface Shape {
  /** Index of the joint it moves with; -1: the base. */
  joint: number;
  /** Of the shape's middle in the joint's frame. */
  p: Vec3;
  q: Quaternion;
  kind: "box" | "cylinder" | "sphere" | "capsule" | "mesh";
  /** m. box: x, y, z edges; cylinder: radius, length along z; sphere: radius; capsule: radius, length along z
   * between the centres of its two half-spheres; mesh: scale in x, y, z (empty: 1). */
  size: number[];
  /** mesh: base64 of little-endian float32, nine per triangle. */
  triangles?: string;
}

export interface Robot {
  name: string;
  joints: Joint[];
  shapes: Shape[];
  /** Shapes of the URDF that could not be drawn: meshes that were not found, are of another kind, or too large. */
  undrawn: number;
  /** Tool frame in the last joint's frame; z is the direction of gaze. */
  tool: { p: Vec3; q: Quaternion };
}

export interface Scenario {
  name: string;
  /** s. */
  duration: number;
  /** Closed polyline of the desired path, m. */
  path: Vec3[];
  /** m; 0 without obstacles. */
  influence_radius: number;
  obstacles: { body_radius: number | null }[];
  /** Names of the controller's states. */
  states: string[];
  /** Index into the report's robots; -1 where the folder does not say: its runs have no replay. */
  robot: number;
  /** At most one per set. */
  runs: Run[];
  /** Of a plan, the strongest first. */
  limits?: PlanLimit[];
}

/** Counts of all evaluations, where there are too many to show. */
export interface ThinnedEvaluations {
  /** Number of each evaluation that is shown. */
  number: number[];
  total: number;
  feasible: number;
  native: number;
  without_objective: number;
  /** Stretches of one phase: index into `phase`, number of the first and of the last evaluation. */
  phase_runs: [number, number, number][];
  /** There are more of them than stand here. */
  more_phase_runs: boolean;
}

export interface Evaluations {
  /** Dictionary of phases: start, sweep, search ... */
  phase: string[];
  /** Per evaluation: index into `phase`. */
  of: number[];
  objective: (number | null)[];
  feasible: boolean[];
  violation: (number | null)[];
  /** Per evaluation: of armtune's own engine, and so neither chosen nor reported; left out where all are Simbody's. */
  native?: boolean[];
  /** Indices of evaluations; -1 if there is none. */
  start: number;
  chosen: number;
  /** Left out where all evaluations are shown. */
  thinned?: ThinnedEvaluations;
}

export interface Gain {
  name: string;
  unit: string;
  lower: number;
  upper: number;
  scale: "log" | "linear";
  values: number[];
}

export interface Sensitivity {
  gain: string;
  /** What the merit loses when this gain alone goes back to its start. */
  importance: number | null;
  /** Change of the merit for a small step of the gain, either way. */
  local: number | null;
  elasticity: number | null;
  rank_correlation: number | null;
}

export interface Margin {
  margin: string;
  unit: string;
  /** Scenario, or "all" for the smallest. */
  scenario: string;
  /** Per set: how far it stands. */
  values: (number | null)[];
  /** Per set, the value in words: "2", "≥ 100" where nothing failed, "none" where not even the nominal value
   * stands, empty where it was not looked for. */
  text: string[];
  /** Per set: why it ends there. */
  reason: string[];
}

/** A target switch, return or lap of a rollout beside the best that the arm's limits allow from the same state. */
export interface YardstickEvent {
  /** Index into `sets`. */
  set: number;
  scenario: string;
  event: "switch" | "return" | "lap";
  /** When it begins, s. */
  time: number;
  /** Of `unit`; null where it was not reached. */
  reached: number | null;
  /** Of `unit`; null where none was found. */
  limit: number | null;
  /** reached / limit; null where there is none. */
  ratio: number | null;
  unit: "s" | "rad";
  /** The limit of the arm that costs the plan most. */
  held_back_by: string;
  /** "reacquired in 1.48 s; the joint limits allow 1.21 s (velocity of elbow_joint)". */
  words: string;
}

export interface Front {
  criteria: { name: string; unit: string }[];
  points: {
    values: number[];
    label: string;
    feasible: boolean;
    /** chosen: of a search, what it ended with; shown: of a front, the one of which replay and tables are. */
    role: "start" | "chosen" | "shown" | "point";
  }[];
  /** What the study allows of a criterion. */
  limits: { criterion: number; value: number }[];
  hypervolume: number | null;
}

export interface Histogram {
  metric: string;
  unit: string;
  scenario: string;
  limit: number | null;
  counts: number[];
  /** Arms that did not complete, of which there is no value. */
  failed: number;
  /** One more than counts. */
  edges: number[];
  nominal: number | null;
}

export interface Robustness {
  samples: number;
  /** Portion of the arms that keep every limit. */
  yield: number;
  /** Its 95 % interval. */
  interval: [number, number];
  histograms: Histogram[];
  worst: { sample: number; text: string }[];
}

/** Of a page that is written again and again while its run goes on. */
export interface Live {
  evaluations: number;
  most_evaluations: number;
  /** About, of the search. */
  seconds_left: number | null;
  /** Seconds after which the page loads itself again. */
  every: number;
  /** When it was written: seconds since 1970. */
  written: number;
}

export interface ReportData {
  format: 1;
  kind: "tune" | "simulate" | "pareto" | "robustness" | "compare" | "plan";
  title: string;
  verdict: { sentence: string; details: string[] };
  live?: Live;
  /** Names of the gain sets; index 0 is the reference, the last is the result. */
  sets: string[];
  tables: Table[];
  judged?: Judged;
  /** Every arm of the scenarios; empty where the folder does not say. */
  robots: Robot[];
  scenarios: Scenario[];
  evaluations?: Evaluations;
  gains?: Gain[];
  sensitivity?: Sensitivity[];
  margins?: Margin[];
  yardstick?: YardstickEvent[];
  front?: Front;
  robustness?: Robustness;
  plan?: Plan;
  provenance: { command: string; entries: [string, string][] };
}
