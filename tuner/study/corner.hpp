#pragma once
// Margins as constraints of a study. There is one corner rollout for each margin and scenario, on the nominal
// arm, with the margin's quantity at the demanded value. The constraint holds exactly if `armtune margins`
// finds that the loop holds there: the rollout completes, keeps the arm's velocity and position limits,
// touches nothing, and saturates a joint in at most 1 % of its periods.

#include <optional>
#include <string>
#include <vector>

#include "sim/rollout/rollout_result.hpp"
#include "tuner/robustness/margin_kind.hpp"
#include "tuner/study/thresholds.hpp"

namespace armtune::internal {

/// A demand on one margin, as a study's `margins` states it: extra periods of delay, a factor on the gains, a
/// factor on the noise, a share of the control rate.
struct MarginDemand {
  MarginKind kind = MarginKind::kTorqueDelay;
  double value = 0.0;
};

/// A key in `margins` and `verdict`, the margin that it stands for, and its default threshold.
struct MarginThreshold {
  const char* key;
  MarginKind kind;
  double VerdictThresholds::*value;
};
const std::array<MarginThreshold, kMarginCount>& margin_thresholds();

/// Returns the value of the margin's own quantity that a demand means in the scenario: noise and rate are
/// multiples of the scenario's own.
double demanded_value(const MarginDemand& demand, const Scenario& scenario);

/// True if the sensors of any scenario are noisy: without noise a factor on it demands nothing.
bool has_noise(const std::vector<Scenario>& scenarios);

/// Returns the scenario with the margin's quantity at the demanded value. Its name is the scenario's,
/// followed by the demand.
Scenario corner_of(const Scenario& scenario, const MarginDemand& demand);

/// Returns by how much the loop fails to hold in a corner rollout; zero or less if it holds. It is the
/// largest of these excesses: velocity (relative to the limit), position [rad, m], depth of a contact [m],
/// saturated periods (relative to those allowed). It is 1 or more if the rollout did not complete.
double missing_to_hold(const RolloutResult& result, const Scenario& corner);

}  // namespace armtune::internal
