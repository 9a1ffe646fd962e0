#include "tuner/first_task/steady_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <optional>
#include <utility>
#include <vector>

#include "armtune/error.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/joint_trajectory_law.hpp"
#include "core/control/laws/starting_gains.hpp"
#include "sim/rollout/shake_watch.hpp"
#include "sim/scenario/gains_file.hpp"
#include "sim/scenario/path_walk.hpp"
#include "sim/scenario/start_of_task.hpp"
#include "tuner/first_task/first_gain_sets.hpp"
#include "tuner/first_task/kept_limits.hpp"
#include "tuner/rollouts/simulate.hpp"
#include "tuner/workers/candidate_runner.hpp"

namespace armtune::internal {
namespace {

constexpr double kCentering = 0.2;  // 1/s, as in starting gains

/// Returns the scenarios' results for every gain set, in armtune's own dynamics.
std::vector<std::vector<RolloutResult>> simulated(const Study& study, const std::vector<Gains>& sets,
                                                  int workers) {
  CandidateRunner runner(study.scenarios, study.stepper, workers);
  const std::atomic<bool> stop = false;
  Conditions conditions;
  conditions.engine = Engine::kNative;
  return *runner.run(sets, stop, {}, conditions);
}

/// Returns how the first scenario that is not completed ends; empty if all are completed.
std::string failure(const Study& study, const std::vector<RolloutResult>& results) {
  for (std::size_t s = 0; s < results.size(); ++s) {
    if (results[s].status != RolloutStatus::kCompleted)
      return fmt::format("{}: {}", study.scenarios[s].name, results[s].reason);
  }
  return {};
}

/// The reason why a study's start gains are not a good reference.
struct Unsteadiness {
  std::string why;        ///< a scenario that is not completed, or a joint that shakes; empty: neither
  bool completes = true;  ///< true if every scenario is completed
};

Unsteadiness unsteadiness(const Study& study, int workers) {
  SimulateOptions how;
  how.stepper = study.stepper;
  how.engine = Engine::kNative;
  how.workers = workers;
  const std::atomic<bool> stop = false;
  const auto start = [&study](const Scenario&) { return study.space.start; };
  Unsteadiness found;
  for (const ScenarioResult& r : simulate(study.scenarios, start, how, stop)) {
    if (r.result.status != RolloutStatus::kCompleted)
      return {fmt::format("{}: {}", r.scenario, r.result.reason), false};
    if (r.shake && found.why.empty()) found.why = fmt::format("{}: {}", r.scenario, to_string(*r.shake));
  }
  return found;
}

bool keep_limits(const std::vector<RolloutResult>& results) {
  return std::all_of(results.begin(), results.end(),
                     [](const RolloutResult& result) { return keeps_limits(result, 1.0); });
}

bool is_free(const GainEntry& entry, const ParameterSpace& space) {
  return std::any_of(space.free.begin(), space.free.end(),
                     [&entry](const Parameter& p) { return p.entry.name == entry.name; });
}

/// Keeps the given values of some of the controller's own gains: of those that are never tuned, and of those
/// that are zero, or a stiffness, and not a parameter of the study.
void keep_untuned(const Gains& given, const Study& study, Gains& gains) {
  const std::vector<std::string> joints = joint_names(*study.scenarios.front().robot);
  for (const GainEntry& entry : gain_entries(given, joints)) {
    if (!std::holds_alternative<OwnGain>(entry.field->member)) continue;
    const double in_file = value(given, entry);
    const bool given_alone = in_file == 0.0 || entry.field->search == SearchRange::kBounded;
    const bool off = given_alone && !is_free(entry, study.space);
    if (off || entry.field->search == SearchRange::kNone) value(gains, entry) = in_file;
  }
}

/// Returns gain sets for the first scenario, with the goal pose and for the controller of `given`.
std::vector<Gains> first_sets(const Study& study, const Gains& given) {
  const Scenario& scenario = study.scenarios.front();
  const RobotModel& robot = *scenario.robot;
  const JointVector goal = best_start_of_task(scenario);
  const PathWalk walk = walk_path(scenario, goal, kCentering);
  Gains start = starting_gains(robot, scenario.start_position, goal, walk.manipulability.value);
  start.joint_space_goal = given.joint_space_goal;
  std::vector<Gains> sets = first_gain_sets(robot, goal, start);
  for (Gains& gains : sets) {
    if (gains.controller != given.controller)
      gains = convert_gains(controller_kind(given.controller), gains, robot, goal);
    keep_untuned(given, study, gains);
    fit_integral_to_clamp(robot, gains);
  }
  return sets;
}

/// Returns the first gain set that completes every scenario within the arm's limits. If there is none,
/// returns the first that completes every scenario; nothing if there is none of these either.
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

/// Returns first gains for a study's scenarios and for the controller of its gains file. Returns nothing if
/// no gain set completes every scenario, or if the task itself is impossible.
std::optional<Gains> first_gains(const Study& study, int workers) {
  const Scenario& first = study.scenarios.front();
  const Gains in_file = load_gains(study.gains, joint_names(*first.robot), {}, study.node, study.distro);
  try {
    return completing(study, first_sets(study, in_file), workers);
  } catch (const InputError&) {
    return std::nullopt;  // the simulation of the start gains reports what is wrong with the task
  }
}

}  // namespace

Study load_steady_study(const std::string& name_or_path, const std::string& controller, int workers) {
  Study study = load_study(name_or_path, controller);
  const Unsteadiness failed = unsteadiness(study, workers);
  if (failed.why.empty()) return study;
  const std::optional<Gains> gains = first_gains(study, workers);
  if (!gains) return study;
  StudyParts parts;
  parts.start = gains;
  parts.joints = joint_names(*study.scenarios.front().robot);
  try {
    Study steady = load_study(name_or_path, controller, parts);
    // The study itself may give start values of single gains, so the computed gains may be changed here.
    if (!unsteadiness(steady, workers).why.empty()) return study;
    steady.given = study.space.start;
    steady.given_failure = failed.why;
    return steady;
  } catch (const InputError& e) {
    if (failed.completes) return study;  // the study can be tuned with its own start gains
    throw InputError(
        e.place().file == study.source ? e.place() : InputPlace{study.source},
        fmt::format(
            "the start gains fail ({}), so the objective cannot be relative to them. armtune also computed start "
            "gains of its own. Every scenario completes with them, but the study does not allow them: {}",
            failed.why, e.what()))
        .with_value(e.value(), e.limit());
  }
}

}  // namespace armtune::internal
