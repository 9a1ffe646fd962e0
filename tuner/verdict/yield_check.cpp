#include "tuner/verdict/yield_check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "sim/scenario/arm_distribution.hpp"
#include "sim/scenario/data_files.hpp"
#include "tuner/samples/statistics.hpp"
#include "tuner/study/thresholds.hpp"
#include "tuner/verdict/assumptions.hpp"
#include "tuner/verdict/rollout_checks.hpp"

namespace armtune::internal {
namespace {

/// The reason why a random arm is not counted in the yield.
struct Cause {
  std::string broken;
  std::size_t scenario = 0;
  std::string joint;  ///< known only for velocity limits
  bool operator<(const Cause& other) const {
    return std::tie(broken, scenario, joint) < std::tie(other.broken, other.scenario, other.joint);
  }
};

Cause cause_of(const MonteCarloSample& sample, std::size_t scenario) {
  const Metrics& metrics = sample.results[scenario].metrics;
  const RolloutFailure& failure = sample.broken[scenario];
  const bool velocity = failure.metric == Metric::kJointVelocityMaxRatio;
  return {failure.text, scenario, velocity ? metrics.max_ratio_joint : std::string()};
}

std::size_t kept_of(const std::vector<MonteCarloSample>& samples) {
  return static_cast<std::size_t>(
      std::count_if(samples.begin(), samples.end(), [](const MonteCarloSample& s) { return s.keeps_all(); }));
}

std::string distribution_text(const std::string& whose, const Perturbation& perturbation) {
  const ArmDistribution& from = *perturbation.distribution;
  std::vector<std::string> not_drawn;
  std::size_t not_told = 0;
  for (const ArmParameter& p : from.parameters) {
    if (!p.is_drawn()) not_drawn.push_back(p.name);
    if (p.is_drawn() && !p.told) ++not_told;
  }
  std::string text = fmt::format("random arms are drawn from the joint distribution of {} parameters in {}",
                                 from.parameters.size() - not_drawn.size(), shown_path(from.file));
  if (not_told > 0)
    text += fmt::format(
        "; the log of the calibration does not tell {} of them, so they vary about as widely as before it",
        not_told);
  if (!not_drawn.empty()) text += fmt::format("; not drawn: {}", fmt::join(not_drawn, ", "));
  if (perturbation.mass > 0.0 || perturbation.center > 0.0 || perturbation.inertia > 0.0) {
    text += fmt::format("; the links differ from the robot file by no more than {} random changes", whose);
  } else {
    text += "; masses, centres of mass and inertia of the links are those of the robot file";
  }
  if (perturbation.payload > 0.0)
    text += fmt::format("; the arms carry further payloads up to {:.3g} kg", perturbation.payload);
  return from.note.empty() ? text : fmt::format("{} ({})", text, from.note);
}

}  // namespace

std::string kept_text(const std::vector<MonteCarloSample>& samples) {
  const std::size_t kept = kept_of(samples);
  const auto [low, high] = wilson_interval(kept, samples.size());
  return fmt::format(
      "{} of {} random arms keep the limits, with saturated torque in at most {:.0f} % of the control "
      "periods (95 % confidence {:.1f} to {:.1f} %)",
      kept, samples.size(), 100.0 * kSaturatedShare, 100.0 * low, 100.0 * high);
}

Check yield_check(const std::vector<Scenario>& scenarios, const std::vector<MonteCarloSample>& samples,
                  double asked) {
  Check check{CheckKind::kYield};
  check.value = static_cast<double>(kept_of(samples)) / static_cast<double>(samples.size());
  check.threshold = asked;
  check.unit = "of the arms";
  check.passed = check.value >= asked;
  // The most frequent failure shows where to look.
  std::map<Cause, std::size_t> causes;
  for (const MonteCarloSample& sample : samples) {
    for (std::size_t s = 0; s < scenarios.size(); ++s) {
      if (!sample.broken[s].text.empty()) ++causes[cause_of(sample, s)];
    }
  }
  if (!causes.empty()) {
    const auto& [cause, count] = *std::max_element(
        causes.begin(), causes.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    check.joint = cause.joint;
    check.scenario = scenarios[cause.scenario].name;
    check.detail = fmt::format("most frequent failure ({} {}{}): {}; ", count, count == 1 ? "arm" : "arms",
                               cause.joint.empty() ? "" : ", at this joint", cause.broken);
  }
  check.detail += kept_text(samples);
  return check;
}

std::string spread_text(const std::string& whose, const Perturbation& perturbation) {
  if (perturbation.distribution) return distribution_text(whose, perturbation);
  return fmt::format("the arm differs from its model by no more than {} random changes ({})", whose,
                     perturbation.payload > 0.0
                         ? fmt::format("with payloads up to {:.3g} kg", perturbation.payload)
                         : std::string("with the scenario's payload"));
}

SimulationVerdict yield_verdict(const std::vector<Scenario>& scenarios,
                                const std::vector<MonteCarloSample>& samples,
                                const MonteCarloOptions& options) {
  SimulationVerdict verdict;
  verdict.checks.push_back(yield_check(scenarios, samples, VerdictThresholds().yield));
  verdict.not_checked = {"the scenario's own arm, without random changes (armtune simulate)",
                         fmt::format("effort limits (only torque that saturates in over {:.0f} % of the "
                                     "control periods fails a sample)",
                                     100.0 * kSaturatedShare),
                         "what happens after the scenarios end (armtune simulate --endurance)",
                         "stability margins (armtune margins)"};
  add_unchecked_contacts(scenarios, verdict);
  verdict.not_checked.insert(verdict.not_checked.end(), never_checked().begin(), never_checked().end());
  for (const MetricLimit& own : arm_limits()) {
    const bool kept = std::any_of(options.limits.begin(), options.limits.end(), [&own](const MetricLimit& l) {
      return l.metric == own.metric && l.upper == own.upper &&
             (l.upper ? l.value <= own.value : l.value >= own.value);
    });
    if (!kept) verdict.not_checked.push_back(fmt::format("{}, because --limit replaces it", to_string(own)));
  }
  verdict.assumes.push_back(spread_text("the given", options.perturbation));
  add_engine_assumption(options.engine, kArmsThatKept, verdict);
  add_assumptions(scenarios, options.stepper, verdict);
  if (verdict.passed()) verdict.notes.push_back(kept_text(samples));
  return verdict;
}

}  // namespace armtune::internal
