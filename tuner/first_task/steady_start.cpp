#include "tuner/first_task/steady_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <optional>
#include <utility>
#include <vector>

#include "armtune/error.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/starting_gains.hpp"
#include "sim/scenario/gains_file.hpp"
#include "sim/scenario/path_walk.hpp"
#include "tuner/first_task/first_gain_sets.hpp"
#include "tuner/first_task/kept_limits.hpp"
#include "tuner/workers/candidate_runner.hpp"

namespace armtune::internal {
namespace {

constexpr double kCentering = 0.2;  // 1/s, of starting gains

/// Returns the scenarios' results for every gain set, in armtune's own dynamics.
std::vector<std::vector<RolloutResult>> simulated(const Study& study, const std::vector<Gains>& sets,
                                                  int workers) {
  CandidateRunner runner(study.scenarios, study.stepper, workers);
  const std::atomic<bool> stop = false;
  Conditions conditions;
  conditions.engine = Engine::kNative;
  return *runner.run(sets, stop, {}, conditions);
}

/// How the first of the scenarios that is not completed ends; empty: all are.
std::string failure(const Study& study, const std::vector<RolloutResult>& results) {
  for (std::size_t s = 0; s < results.size(); ++s) {
    if (results[s].status != RolloutStatus::kCompleted)
      return fmt::format("{}: {}", study.scenarios[s].name, results[s].reason);
  }
  return {};
}

bool keep_limits(const std::vector<RolloutResult>& results) {
  return std::all_of(results.begin(), results.end(),
                     [](const RolloutResult& result) { return keeps_limits(result, 1.0); });
}

/// What a controller's own gains are that are not tuned: a file's stay.
void keep_untuned(const Gains& given, Gains& gains) {
  for (const GainField& field : fields_of(given)) {
    const auto* own_gain = std::get_if<OwnGain>(&field.member);
    if (own_gain != nullptr && field.search == SearchRange::kNone)
      gains.own[own_gain->place] = given.own[own_gain->place];
  }
}

/// Gains for the first scenario, with the goal pose that `given` has, and of its kind.
std::vector<Gains> first_sets(const Scenario& scenario, const Gains& given) {
  const RobotModel& robot = *scenario.robot;
  const JointVector goal = best_start_of_task(scenario);
  const PathWalk walk = walk_path(scenario, goal, kCentering);
  Gains start = starting_gains(robot, scenario.start_position, goal, walk.manipulability.value);
  start.joint_space_goal = given.joint_space_goal;
  std::vector<Gains> sets = first_gain_sets(robot, goal, start);
  for (Gains& gains : sets) {
    if (gains.controller != given.controller)
      gains = controlled_by(controller_kind(given.controller), gains, robot, goal);
    keep_untuned(given, gains);
  }
  return sets;
}

/// The first gain set with which every scenario is completed, inside the arm's limits if there is one; none
/// if there is no such set.
std::optional<Gains> completing(const Study& study, const std::vector<Gains>& sets, int workers) {
  const auto results = simulated(study, sets, workers);
  std::optional<Gains> completes;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    if (!failure(study, results[i]).empty()) continue;
    if (keep_limits(results[i])) return sets[i];
    if (!completes) completes = sets[i];
  }
  return completes;
}

/// First gains for a study's scenarios, of the kind that its file gives; none where the task itself is
/// impossible.
std::optional<Gains> first_gains(const Study& study, int workers) {
  const Scenario& first = study.scenarios.front();
  const Gains in_file = load_gains(study.gains, joint_names(*first.robot), {}, study.node);
  try {
    return completing(study, first_sets(first, in_file), workers);
  } catch (const InputError&) {
    return std::nullopt;  // what is wrong with the task is said where the start gains are simulated
  }
}

}  // namespace

Study load_steady_study(const std::string& name_or_path, const std::string& controller, int workers) {
  Study study = load_study(name_or_path, controller);
  const std::string failed = failure(study, simulated(study, {study.space.start}, workers).front());
  if (failed.empty()) return study;
  const std::optional<Gains> gains = first_gains(study, workers);
  if (!gains) return study;
  StudyParts parts;
  parts.start = gains;
  parts.joints = joint_names(*study.scenarios.front().robot);
  try {
    Study steady = load_study(name_or_path, controller, parts);
    // A study may give single gains' starts itself.
    if (!failure(steady, simulated(steady, {steady.space.start}, workers).front()).empty()) return study;
    steady.given = study.space.start;
    steady.given_failure = failed;
    return steady;
  } catch (const InputError& e) {
    throw InputError(fmt::format(
        "{}: the start gains cannot be a reference ({}). The arm completes the study with first gains of armtune's, "
        "but these do not fit the study: {}",
        study.source, failed, e.what()));
  }
}

}  // namespace armtune::internal
