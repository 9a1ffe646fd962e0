#include "tuner/planning/tasks/given_states.hpp"

#include <fmt/format.h>

#include "armtune/error.hpp"
#include "sim/scenario/data_files.hpp"
#include "tuner/planning/transcription/arm_terms.hpp"

namespace armtune::internal {
namespace {

constexpr double kRounding = 1e-9;  // allowance for rounding errors, relative to a limit

std::vector<double> values(const KnotTerm& term, const Knot& knot) {
  std::vector<double> value(term.rows.size());
  KnotRows rows;
  rows.value = value.data();
  term.evaluate(knot, rows);
  return value;
}

/// Throws InputError if the state violates one of the term's limits. key: task key, for the message.
void check(const KnotTerm& term, const Knot& state, const PlanTask& task, const char* key,
           const char* advice) {
  if (const auto broken = broken_term(term, state))
    throw InputError(
        InputPlace{shown_path(task.source), 0, key},
        fmt::format("{}: {}, but the task's limit is {:.4g}; {}", key, broken->value, broken->limit, advice))
        .with_value(
            fmt::format("{:.4g}", broken->number),
            fmt::format("{} {:.4g}", broken->number < broken->limit ? "at least" : "at most", broken->limit));
}

}  // namespace

Knot at_rest(const RobotModel& robot, const JointVector& q, double time) {
  Knot knot;
  knot.time = time;
  knot.q = q;
  forward_kinematics(robot.chain, q, knot.poses);
  knot.qd = knot.qdd = JointVector::Zero(robot.n());
  return knot;
}

std::optional<BrokenTerm> broken_term(const KnotTerm& term, const Knot& state) {
  const std::vector<double> value = values(term, state);
  for (std::size_t row = 0; row < value.size(); ++row) {
    const bool below = value[row] < term.lower - kRounding;
    if (!below && value[row] <= term.upper + kRounding) continue;
    const double number = term.natural(row, value[row]);
    return BrokenTerm{
        fmt::format("{} of {} would be {:.4g} {}", term.name, term.rows[row], number, term.units[row]),
        term.natural(row, below ? term.lower : term.upper), number};
  }
  return std::nullopt;
}

void check_given_states(const PlanCommon& common) {
  const PlanTask& task = common.task;
  Knot knot = at_rest(*common.robot, common.start.position, task.at);
  constexpr const char* kElsewhere = "reduce 'clearance', or give another 'start'";
  if (task.clearance > 0.0) {
    for (const MovingObstacle& obstacle : task.scenario.obstacles)
      check(clear_of(*common.robot, {0, 0}, obstacle, task.clearance), knot, task, "clearance", kElsewhere);
    if (task.scenario.clearance) {
      for (const KnotTerm& term : clear_of_cell(task.scenario.clearance, {0, 0}, task.clearance))
        check(term, knot, task, "clearance", kElsewhere);
    }
  }
  constexpr const char* kLessTorque = "choose a state that needs less torque, or raise limits/effort";
  const KnotTerm torque = torque_limits(*common.robot, {0, 0}, task.limits.effort);
  if (common.start.acceleration.size() > 0) {
    knot.qd = common.start.velocity;
    knot.qdd = common.start.acceleration;
    check(torque, knot, task, "start", kLessTorque);
  }
  if (task.goal.size() > 0)
    check(torque, at_rest(*common.robot, task.goal, task.at), task, "goal", kLessTorque);
}

double clearance_at(const RobotModel& robot, const JointVector& q, double time,
                    const std::vector<MovingObstacle>& obstacles) {
  Poses poses;
  forward_kinematics(robot.chain, q, poses);
  return clearance_at(robot.chain, poses, time, obstacles);
}

}  // namespace armtune::internal
