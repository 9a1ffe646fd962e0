#include "tuner/study/corner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/rollout/applies.hpp"
#include "tuner/robustness/margins.hpp"

namespace armtune::internal {

const std::array<MarginThreshold, kMarginCount>& margin_thresholds() {
  static constexpr std::array<MarginThreshold, kMarginCount> all{{
      {"delay_periods", MarginKind::kTorqueDelay, &VerdictThresholds::delay_periods},
      {"gain", MarginKind::kGainFactor, &VerdictThresholds::gain},
      {"rate", MarginKind::kControlRate, &VerdictThresholds::rate},
      {"noise", MarginKind::kVelocityNoise, &VerdictThresholds::noise},
  }};
  return all;
}

double demanded_value(const MarginDemand& demand, const Scenario& scenario) {
  const bool relative = demand.kind == MarginKind::kControlRate || demand.kind == MarginKind::kVelocityNoise;
  return relative ? demand.value * field(demand.kind).nominal(scenario) : demand.value;
}

bool has_noise(const std::vector<Scenario>& scenarios) {
  return std::any_of(scenarios.begin(), scenarios.end(),
                     [](const Scenario& s) { return s.plant.velocity_noise > 0.0; });
}

Scenario corner_of(const Scenario& scenario, const MarginDemand& demand) {
  Scenario corner = scenario;
  Gains none;
  field(demand.kind).apply(demanded_value(demand, scenario), corner, none);
  corner.name = fmt::format("{}+{}_{}", scenario.name, name(demand.kind), demand.value);
  corner.pushed = true;
  return corner;
}

double missing_to_hold(const RolloutResult& result, const Scenario& corner) {
  if (result.status != RolloutStatus::kCompleted) {
    return 2.0 - std::clamp(result.end_time / corner.duration, 0.0, 1.0);
  }
  const auto allowed = static_cast<double>(saturated_periods_allowed(corner));
  const double saturated = result.metrics[Metric::kJointEffortSaturatedPeriods];
  double missing = result.metrics[Metric::kJointVelocityMaxRatio] - 1.0;
  if (applies(Metric::kJointPositionMinMargin, corner)) {
    missing = std::max(missing, -result.metrics[Metric::kJointPositionMinMargin]);
  }
  if (applies(Metric::kJointAccelerationMaxRatio, corner)) {
    missing = std::max(missing, result.metrics[Metric::kJointAccelerationMaxRatio] - 1.0);
  }
  for (const Metric contact : kContactMetrics) {
    if (applies(contact, corner)) missing = std::max(missing, -result.metrics[contact]);
  }
  return std::max(missing, (saturated - allowed) / std::max(1.0, allowed));
}

}  // namespace armtune::internal
