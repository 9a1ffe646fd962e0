#pragma once
// Margins as constraints of a study: one corner rollout for each margin and scenario, on the nominal arm,
// with the margin's quantity at the value that is demanded. The constraint holds exactly where `armtune
// margins` says that the loop holds there: the rollout completes, keeps the arm's velocity and position
// limits, and saturates a joint in at most 1 % of its periods.

#include <optional>
#include <string>
#include <vector>

#include "sim/rollout/rollout_result.hpp"
#include "tuner/robustness/margin_kind.hpp"
#include "tuner/study/thresholds.hpp"

namespace armtune::internal {

/// A demand on one margin, in the words of a study's `margins`: extra periods of delay, a factor on the
/// gains, a factor on the noise, a share of the control rate.
struct MarginDemand {
  MarginKind kind = MarginKind::kTorqueDelay;
  double value = 0.0;
};

/// The key in `margins` and `verdict`, the kind it stands for, and its default threshold.
struct MarginThreshold {
  const char* key;
  MarginKind kind;
  double VerdictThresholds::*value;
};
const std::array<MarginThreshold, kMarginCount>& margin_thresholds();

/// The margin's own quantity where a demand asks for it: noise and rate are multiples of the scenario's own.
double demanded_value(const MarginDemand& demand, const Scenario& scenario);

/// True if the sensors of any scenario are noisy: without noise a factor on it demands nothing.
bool has_noise(const std::vector<Scenario>& scenarios);

/// The scenario pushed to the demand. Its name is the scenario's with the demand behind it.
Scenario corner_of(const Scenario& scenario, const MarginDemand& demand);

/// By how much the loop fails to hold in a corner rollout: zero or less where it holds. The largest of what
/// is missing in velocity (over the limit), position [rad, m] and saturated periods (over those that are
/// allowed); 1 and more where it did not complete.
double missing_to_hold(const RolloutResult& result, const Scenario& corner);

}  // namespace armtune::internal
