#include "tuner/first_task/first_trial.hpp"

#include <fmt/format.h>

#include <atomic>

#include "core/control/laws/starting_gains.hpp"
#include "core/robot/rotor_estimate.hpp"
#include "tuner/endurance/endurance.hpp"
#include "tuner/first_task/first_gain_sets.hpp"
#include "tuner/first_task/kept_limits.hpp"
#include "tuner/first_task/other_arms.hpp"

namespace armtune::internal {

FirstTrial::FirstTrial(const DefaultTask& task, int workers)
    : scenario_(task.scenario),
      workers_(workers),
      gains_(first_gain_sets(
          *scenario_.robot, task.goal,
          starting_gains(*scenario_.robot, scenario_.start_position, task.goal, task.manipulability))),
      native_({scenario_}, Stepper::kMidpoint, workers),
      demands_(scenario_, gains_.front(), workers) {
  if (scenario_.robot->estimated_rotors.empty()) return;
  for (const double factor : {1.0 / kRotorFactor, kRotorFactor})
    other_rotors_.push_back(with_rotors_scaled(scenario_, factor));
}

std::optional<TriedGains> FirstTrial::find() {
  const std::atomic<bool> stop = false;
  Conditions conditions;
  conditions.engine = Engine::kNative;
  conditions.limits = {ends_of_kept_limits(scenario_, kFirstTaskRatio)};
  const auto quick = *native_.run(gains_, stop, {}, conditions);
  for (std::size_t i = 0; i < gains_.size(); ++i) {
    if (!passes(quick[i].front(), "")) continue;
    if (const auto metrics = completed_with(gains_[i])) return TriedGains{gains_[i], *metrics};
  }
  return std::nullopt;
}

/// Simulates the constraints first, in armtune's own dynamics, because these are quick. The task itself must
/// be completed in Simbody.
std::optional<Metrics> FirstTrial::completed_with(const Gains& gains) {
  if (const std::string broken = demands_.broken(gains); !broken.empty()) {
    failed_ = broken;
    return std::nullopt;
  }
  if (!simbody_) simbody_.emplace(scenario_, Stepper::kMidpoint, Engine::kSimbody);
  const EndLimits ends = ends_of_kept_limits(scenario_, kFirstTaskRatio);
  const RolloutResult result = simbody_->run(gains, {}, ends);
  if (!passes(result, "")) return std::nullopt;
  for (const Scenario& scenario : other_rotors_) {
    Rollout other(scenario, Stepper::kMidpoint, Engine::kSimbody);
    if (!passes(other.run(gains, {}, ends), " if the rotor inertia differs from the estimate"))
      return std::nullopt;
  }
  if (!endures(gains)) return std::nullopt;
  if (nearly_all_hold(scenario_, gains, workers_)) return result.metrics;
  failed_ = fmt::format("more than {} of {} random arms break their limits", most_lost_arms(), kOtherArms);
  return std::nullopt;
}

/// Simulates as long as the verdict on a search does, because slow drifts do not show in one task. The share
/// of the limits is smaller than in the verdict, to leave room for the gains that are tuned from these.
bool FirstTrial::endures(const Gains& gains) {
  const std::atomic<bool> stop = false;
  const auto gains_of = [&gains](const Scenario&) { return gains; };
  EnduranceOptions how;
  how.limit_share = kFirstTaskRatio;
  how.confirmed = false;  // if these gains fail, others are tried; Simbody need not decide
  const EnduranceResult result = endure({scenario_}, gains_of, how, stop).front();
  if (!result.held()) {
    failed_ = result.broken ? to_string(*result.broken) : result.ended;
    return false;
  }
  // The growth is NaN if there was nothing to compare.
  const VerdictThresholds most;
  if (!(result.rms_growth > most.rms_growth) && !(result.peak_growth > most.peak_growth)) return true;
  failed_ = fmt::format("errors grow within {} simulated minutes", most.minutes);
  return false;
}

bool FirstTrial::passes(const RolloutResult& result, const char* where) {
  if (keeps_limits(result, kFirstTaskRatio)) return true;
  failed_ = lost_limits(result, kFirstTaskRatio) + where;
  return false;
}

}  // namespace armtune::internal
