#pragma once
// Stability margins as constraints of a study. For each demanded margin and scenario there is one extra
// rollout of the nominal arm, called a corner. In it the margin's quantity, such as a delay, has the demanded
// value. The constraint holds exactly if `armtune margins` finds the loop stable there: the rollout
// completes, keeps the arm's velocity and position limits, touches nothing, and saturates a joint in at most
// 1 % of its periods.

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

/// Returns the value that the margin's quantity must have in the scenario to meet the demand. Noise and rate
/// are demanded as multiples of the scenario's own values.
double demanded_value(const MarginDemand& demand, const Scenario& scenario);

/// True if the sensors of any scenario are noisy. Without noise, a factor on the noise demands nothing.
bool has_noise(const std::vector<Scenario>& scenarios);

/// Returns the scenario with the margin's quantity at the demanded value. Its name is the scenario's,
/// followed by the demand.
Scenario corner_of(const Scenario& scenario, const MarginDemand& demand);

/// Returns by how much the loop misses stability in a corner rollout; zero or less if it is stable. It is the
/// largest of these excesses: velocity (relative to the limit), position [rad, m], depth of a contact [m],
/// saturated periods (relative to those allowed). It is 1 or more if the rollout did not complete.
double missing_to_hold(const RolloutResult& result, const Scenario& corner);

}  // namespace armtune::internal
