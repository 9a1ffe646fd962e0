#include "tuner/planning/tasks/given_states.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/common/error.hpp"
#include "sim/scenario/data_files.hpp"
#include "tuner/planning/transcription/arm_terms.hpp"

namespace armtune {
namespace {

constexpr double kRounding = 1e-9;  // of a limit

/// Throws where the state that `key` gives breaks one of the term's limits.
void check(const KnotTerm& term, const Knot& state, const PlanTask& task, const char* key,
           const char* advice) {
  std::vector<double> value(term.rows.size());
  KnotRows rows;
  rows.value = value.data();
  term.evaluate(state, rows);
  for (std::size_t row = 0; row < value.size(); ++row) {
    const bool below = value[row] < term.lower - kRounding;
    if (!below && value[row] <= term.upper + kRounding) continue;
    throw InputError(fmt::format("{}: {}: {} of {} would be {:.4g} {}; the task's limit is {:.4g}: {}",
                                 shown_path(task.source), key, term.name, term.rows[row],
                                 term.natural(row, value[row]), term.units[row],
                                 term.natural(row, below ? term.lower : term.upper), advice));
  }
}

}  // namespace

void check_given_states(const PlanCommon& common) {
  const PlanTask& task = common.task;
  const Chain& chain = common.robot->chain;
  Knot knot;
  knot.time = task.at;
  knot.q = common.start.position;
  forward_kinematics(chain, knot.q, knot.poses);
  if (task.clearance > 0.0) {
    for (const NamedPath& obstacle : task.scenario.obstacles)
      check(clear_of(*common.robot, {0, 0}, obstacle.name, obstacle.path, task.clearance), knot, task,
            "clearance", "ask for less, or start elsewhere");
  }
  constexpr const char* kLessTorque = "choose a state that takes less, or a larger limits/effort";
  const KnotTerm torque = torque_limits(*common.robot, {0, 0}, task.limits.effort);
  if (common.start.acceleration.size() > 0) {
    knot.qd = common.start.velocity;
    knot.qdd = common.start.acceleration;
    check(torque, knot, task, "start", kLessTorque);
  }
  if (task.goal.size() > 0) {
    knot.q = task.goal;
    forward_kinematics(chain, knot.q, knot.poses);
    knot.qd.setZero(common.n());
    knot.qdd.setZero(common.n());
    check(torque, knot, task, "goal", kLessTorque);
  }
}

}  // namespace armtune
