#pragma once
// The data about one scenario on a report page: either the rollouts of the scenario with their plots and 3D
// replays, or a planned motion with its plots, its replay and its limits.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/control/state_machine.hpp"
#include "tuner/record/declaration.hpp"
#include "tuner/report/arm.hpp"
#include "tuner/report/series.hpp"

namespace armtune::internal::report {

using enum record::Presence;

/// Names of the plots on a page.
inline constexpr record::Words kPlots = {"position",       "position_error",     "orientation_error",
                                         "gaze",           "joint_position",     "linear_velocity_error",
                                         "velocity_ratio", "joint_velocity",     "angular_velocity_error",
                                         "torque_ratio",   "joint_acceleration", "slide_position",
                                         "joint_error",    "joint_jerk",         "slide_velocity",
                                         "theta",          "joint_torque",       "slide_acceleration",
                                         "clearance",      "slide_jerk",         "slide_torque",
                                         "manipulability"};

struct PlotColumn {
  std::string name, group, unit;
  Series series;

  static void declare(auto& f, auto& column) {
    f.type("Column");
    f("name", column.name,
      "Name in rollout_*.csv, such as error/position/x or joint/elbow_joint/velocity_ratio.");
    f("group", column.group, kPlots, "The plot that shows the column.")("unit", column.unit);
    f("series", column.series, "Values; as many points as the run's `time`.");
  }
};

struct Replay {
  double dt = 0.0;
  std::size_t n = 0;
  std::vector<Series> q, target;
  std::vector<std::vector<Series>> obstacles, cell;
  std::vector<Series> closest;
  std::vector<Series> tool;
  Series error;
  std::vector<Series> velocity_ratio;

  static void declare(auto& f, auto& replay) {
    f.type("Replay", "Sampled evenly in time: point i is at i * dt. All series have n points.");
    f("dt", replay.dt, "Sample period, s.")("n", replay.n, "Number of points; 0 if the run has no replay.");
    f("q", replay.q, "Position of each joint, rad or m.");
    f("target", replay.target, "x, y, z of the active target in the base frame; empty without a target.");
    f("obstacles", replay.obstacles, "x, y, z of each obstacle's centre.")("tool", replay.tool, "x, y, z.");
    f("cell", replay.cell, "x, y, z of the centre of each part of the cell.");
    f("closest", replay.closest,
      "x, y, z of the arm's point with the smallest clearance, then x, y, z of the nearest point that the "
      "arm must not touch; empty if no clearance was computed.");
    f("error", replay.error, "Norm of the position error, m; no value in states that track no position.");
    f("velocity_ratio", replay.velocity_ratio,
      "|velocity| / limit of each joint: the largest within dt / 2 of the sample, to miss no peak.");
  }
};

struct StateChange {
  double time = 0.0;
  int state = 0;

  static void declare(auto& f, auto& change) {
    f.type("StateChange")("t", change.time, "s.");
    f("state", change.state, "Index into the scenario's `states`.");
  }
};

struct Run {
  std::size_t set = 0;
  std::string status, reason;
  double start = 0.0, end = 0.0;
  std::vector<StateChange> states;
  std::vector<std::pair<double, double>> slerps;
  double shortest_state = 0.0;  ///< states and slerps shorter than this [s] are left out
  Series time;
  std::vector<PlotColumn> columns;
  Replay replay;

  static void declare(auto& f, auto& run) {
    f.type("Run")("set", run.set, "Index into `sets`.")("status", run.status);
    f("reason", run.reason, "When, where and why the run ended; empty if it completed.");
    f("start", run.start,
      "Time of the scenario at which the run begins, s: 0, or the start of a planned trajectory. All other "
      "times count from it.");
    f("end", run.end, "Time at which the run ended, s; below the duration if it did not complete.");
    f("states", run.states, "Changes, in order.")("slerps", run.slerps,
                                                  "Start and end of every slerp (turn of the tool), s.");
    f("time", run.time,
      "Times, s, not decreasing. A short run has every sample. A longer one is cut into equal intervals "
      "of two points each: of every column the smallest and the largest value, in the order in which they "
      "occur.");
    f("columns", run.columns)("replay", run.replay);
  }
};

struct PlanLimit {
  std::string limit, part, words, unit;
  double lower = 0.0, upper = 0.0, from = 0.0, to = 0.0;
  double at_knots = 0.0, between_knots = 0.0, active = 0.0, strength = 0.0;
  std::vector<std::pair<double, double>> active_lower, active_upper;
  std::string group, column;

  static void declare(auto& f, auto& limit) {
    f.type("PlanLimit",
           "A limit of one joint or axis that a plan keeps. Times count from the plan's start, s.");
    f("limit", limit.limit, "\"velocity\", \"torque\", \"gaze\" ...")("part", limit.part,
                                                                      "The joint or axis.");
    f("words", limit.words, "Limit and part: \"torque of elbow_joint\", \"gaze\".")("unit", limit.unit);
    f("lower", limit.lower, "Lower bound in `unit`; null: no bound on this side.", kOrNull)(
        "upper", limit.upper, "", kOrNull);
    f("from", limit.from, "Time from which the limit holds.")("to", limit.to);
    f("at_knots", limit.at_knots, "Largest share of the limit that is used at the knots of the time grid.",
      kOrNull);
    f("between_knots", limit.between_knots,
      "Largest share that is used between the knots, where the limit is not enforced.", kOrNull);
    f("active", limit.active, "Share of the knots at which the limit is active.");
    f("strength", limit.strength,
      "Sum of its Lagrange multipliers: time in s, or cost, saved per unit of relaxation; 0 if inactive.");
    f("active_lower", limit.active_lower)("active_upper", limit.active_upper);
    f("group", limit.group, kPlots, "The plot that shows it.")("column", limit.column, "The limited column.");
  }
};

struct ReportPart {
  std::string name;
  ArmShape shape;

  static void declare(auto& f, auto& part) {
    f.type("CellPart")("name", part.name)("shape", part.shape, "`q` turns the shape about its centre.");
  }
};

struct ReportScenario {
  std::string name;
  double duration = 0.0;
  std::vector<Vec3> path;
  double influence_radius = 0.0;
  std::vector<double> obstacles;
  std::vector<ReportPart> cell;
  std::optional<double> floor;
  long arm = -1;
  std::vector<Run> runs;
  std::vector<PlanLimit> limits;

  static void declare(auto& f, auto& scenario) {
    f.type("Scenario")("name", scenario.name)("duration", scenario.duration, "s.");
    f("path", scenario.path, "Closed polyline of the desired path, m.");
    f("influence_radius", scenario.influence_radius, "m; 0 without obstacles.");
    f("obstacles", scenario.obstacles, "Radius of each obstacle's body, m.");
    f("cell", scenario.cell, "Parts of the cell around the arm.");
    f("floor", scenario.floor, "Height of the floor above the base frame's origin, m; null if unknown.");
    f("states", record::names_of<ControlState>(), "Names of the controller's states.");
    f("robot", scenario.arm,
      "Index into `robots`; -1 if the arm is unknown, and its runs then have no replay.");
    f("runs", scenario.runs, "At most one per set.");
    f("limits", scenario.limits, "Limits of a plan, the strongest first.", kIfAny);
  }
};

}  // namespace armtune::internal::report
