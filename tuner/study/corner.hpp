#pragma once
// Stability margins as constraints of a study. For each demanded margin and each scenario there is one
// further rollout of the nominal arm. Its scenario is called a corner: a copy of the scenario in which the
// margin's quantity, such as a delay, is changed as demanded. The constraint holds if the loop is stable in
// the corner. `armtune margins` uses the same definition: the rollout completes, keeps the arm's limits of
// velocity, position and (if given) acceleration, touches nothing, and saturates a torque in at most 1 % of
// the control periods.

#include <optional>
#include <string>
#include <vector>

#include "sim/rollout/rollout_result.hpp"
#include "tuner/robustness/margin_kind.hpp"
#include "tuner/study/thresholds.hpp"

namespace armtune::internal {

/// A demand on one margin, as a study's `margins` states it.
struct MarginDemand {
  MarginKind kind = MarginKind::kTorqueDelay;
  /// For delay: additional control periods. For gain, noise and control rate: a factor on the nominal value.
  double value = 0.0;
};

/// A key in a study's `margins` and `verdict`, with the margin and the threshold that it sets.
struct MarginThreshold {
  const char* key;
  MarginKind kind;
  double VerdictThresholds::*value;
};
const std::array<MarginThreshold, kMarginCount>& margin_thresholds();

/// Returns the demanded value of the margin's quantity in the scenario, in the unit of the quantity. For
/// noise and control rate, this is the factor of the demand times the scenario's own value.
double demanded_value(const MarginDemand& demand, const Scenario& scenario);

/// True if the sensors of any scenario are noisy. Without noise, a factor on the noise has no effect.
bool has_noise(const std::vector<Scenario>& scenarios);

/// Returns the corner: the scenario with the margin's quantity at the demanded value. Its name is the
/// scenario's name, followed by the demand.
Scenario corner_of(const Scenario& scenario, const MarginDemand& demand);

/// Returns by how much the condition of stability is violated in the rollout of a corner. The result is zero
/// or less if the loop is stable. It is the largest of these numbers:
/// - velocity beyond the limit, relative to the limit;
/// - position beyond the limit [rad, m];
/// - depth of a contact [m];
/// - number of saturated periods beyond the allowed number, relative to the allowed number.
/// If the rollout did not complete, the result is from 1 to 2.
double missing_to_hold(const RolloutResult& result, const Scenario& corner);

}  // namespace armtune::internal
