#include "random_plans.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "armtune/error.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/scenario.hpp"
#include "sim/scenario/uniform.hpp"
#include "tuner/planning/solver/violation_price.hpp"

namespace armtune::internal {
namespace {

using Eigen::VectorXd;

constexpr double kReach = 2.0;         // largest distance from the middle of a joint's range [rad, m]
constexpr double kWithin = 0.9;        // largest share of a joint's range
constexpr double kAllowed = 1e-6;      // allowed violation at the ends
constexpr double kAcceleration = 0.1;  // least time from rest to the velocity limit [s]; at most thrice that
constexpr double kJerk = 0.05;         // least time to the acceleration limit [s]; at most thrice that

struct Kind {
  const char* name;
  PlanKind kind;
  std::vector<const char*> scenarios;
};

/// Returns the kinds of tasks. They are drawn in turn, so every kind gets the same number of tasks.
const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = {
      {"move", PlanKind::kMove, {"moving_target", "panda_moving_target", "youbot_moving_target"}},
      {"move_jerk", PlanKind::kMove, {"moving_target", "panda_moving_target", "youbot_moving_target"}},
      {"obstacles", PlanKind::kMove, {"obstacle_pass", "panda_obstacle_pass"}},
      {"switch", PlanKind::kSwitch, {"target_switch", "panda_target_switch", "youbot_target_switch"}},
      {"least_error", PlanKind::kSwitch, {"target_switch", "panda_target_switch", "youbot_target_switch"}},
      {"return", PlanKind::kReturn, {"moving_target", "panda_moving_target", "youbot_moving_target"}},
      {"lap", PlanKind::kTrack, {"moving_target", "panda_moving_target", "youbot_moving_target"}},
      {"fastest", PlanKind::kFastest, {"moving_target", "panda_moving_target", "youbot_moving_target"}}};
  return all;
}

JointVector draw_position(const RobotModel& robot, std::mt19937_64& random) {
  JointVector q(robot.n());
  for (int i = 0; i < robot.n(); ++i) {
    const JointLimits& limits = robot.joints[static_cast<std::size_t>(i)].limits;
    double middle = 0.0;
    double half = kReach;
    if (limits.has_position) {
      middle = 0.5 * (limits.lower + limits.upper);
      half = std::min(kReach, kWithin * 0.5 * (limits.upper - limits.lower));
    }
    q[i] = uniform(random, middle - half, middle + half);
  }
  return q;
}

/// Returns `from` with every joint moved by up to `by` [rad, m], within its position limits.
JointVector draw_near(const RobotModel& robot, const JointVector& from, double by, std::mt19937_64& random) {
  JointVector q = from;
  for (int i = 0; i < robot.n(); ++i) {
    const JointLimits& limits = robot.joints[static_cast<std::size_t>(i)].limits;
    q[i] += uniform(random, -by, by);
    if (limits.has_position) q[i] = std::clamp(q[i], limits.lower, limits.upper);
  }
  return q;
}

PlanTask draw_task(const Kind& kind, int knots, std::mt19937_64& random) {
  const auto chosen =
      static_cast<std::size_t>(uniform(random, 0.0, static_cast<double>(kind.scenarios.size())));
  PlanTask task;
  task.kind = kind.kind;
  task.knots = knots;
  task.scenario = load_scenario(find_data_file("scenarios", kind.scenarios[chosen]));
  task.source = task.scenario.source;
  const RobotModel& robot = *task.scenario.robot;
  task.limits.velocity = uniform(random, 0.3, 1.0);
  task.limits.effort = uniform(random, 0.7, 1.0);
  task.at = uniform(random, 8.0, 20.0);
  const std::string name = kind.name;
  if (name == "move_jerk" || uniform(random, 0.0, 1.0) < 0.25) {
    const JointVector velocity = task.limits.velocity * robot.velocity_limits();
    task.limits.acceleration = velocity / uniform(random, kAcceleration, 3.0 * kAcceleration);
    if (name == "move_jerk")
      task.limits.jerk = task.limits.acceleration / uniform(random, kJerk, 3.0 * kJerk);
  }
  if (kind.kind == PlanKind::kMove) {
    task.start.position = draw_position(robot, random);
    task.goal = draw_position(robot, random);
  }
  if (name == "obstacles") task.clearance = uniform(random, 0.1, 0.3);
  if (kind.kind == PlanKind::kSwitch) {
    const double every = task.scenario.switch_every;
    task.at = every * std::floor(uniform(random, 1.0, 5.0));
    task.path_tolerance = uniform(random, 1e-3, 1e-2);
    task.gaze_threshold = uniform(random, 0.08, 0.2);
  }
  if (name == "least_error") {
    task.least_error = true;
    task.duration = uniform(random, 0.6, 1.5);
  }
  if (kind.kind == PlanKind::kReturn) {
    task.start.position = draw_near(robot, task.scenario.start_position, 0.5, random);
    task.end_gaze = uniform(random, 0.0, 1.0) < 0.5;
  }
  if (kind.kind == PlanKind::kTrack) task.duration = uniform(random, 2.0, 10.0);
  if (kind.kind == PlanKind::kFastest) task.path_tolerance = uniform(random, 1e-3, 1e-2);
  return task;
}

/// Returns true if the first and last knots of the guess keep the position limits and the distances.
bool ends_within_limits(const PlanProblem& problem) {
  TrajectoryProgram program(problem.task(problem.grid));
  VectorXd residual, row;
  program.evaluate(program.unknowns(problem.guess), residual, row);
  const int last = problem.grid.intervals();
  for (Eigen::Index i = 0; i < row.size(); ++i) {
    if (violation(program.bounds, i, row[i]) <= kAllowed) continue;
    const RowMeaning meaning = program.meaning(i);
    const bool at_end = meaning.knot == 0 || meaning.knot == last;
    if (at_end && (meaning.limit == "position" || meaning.limit.starts_with("distance"))) return false;
  }
  return true;
}

}  // namespace

std::vector<RandomPlan> random_plans(int count, int knots, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<RandomPlan> plans;
  while (static_cast<int>(plans.size()) < count) {
    const Kind& kind = kinds()[plans.size() % kinds().size()];
    try {
      RandomPlan plan;
      plan.task = draw_task(kind, knots, random);
      plan.task.name = fmt::format("{}_{}_{}", plans.size() + 1, kind.name, plan.task.scenario.robot->name);
      plan.problem = plan_problem(plan.task);
      if (plan.task.kind == PlanKind::kMove && !ends_within_limits(plan.problem)) continue;
      plans.push_back(std::move(plan));
    } catch (const InputError&) {  // out of reach: drawn again
    }
  }
  return plans;
}

}  // namespace armtune::internal
