#include <algorithm>

#include "sim/rollout/applies.hpp"
#include "tuner/derivatives/metric_derivatives.hpp"

namespace armtune::internal {
namespace {

void add_use(std::vector<MetricUse>& uses, const MetricUse& use) {
  if (std::find(uses.begin(), uses.end(), use) == uses.end()) uses.push_back(use);
}

}  // namespace

std::vector<MetricUse> metrics_in_use(const Study& study) {
  std::vector<MetricUse> uses;
  for (const ObjectiveTerm& term : study.terms) {
    for (const std::size_t s : term.scenarios) add_use(uses, {term.metric, s});
  }
  std::vector<Metric> of_corners = {Metric::kJointVelocityMaxRatio, Metric::kJointPositionMinMargin,
                                    Metric::kJointAccelerationMaxRatio};
  of_corners.insert(of_corners.end(), kContactMetrics.begin(), kContactMetrics.end());
  const std::vector<Scenario> scenarios = simulated_scenarios(study);
  for (const Constraint& constraint : study.constraints) {
    const std::vector<Metric> metrics =
        constraint.margin ? of_corners : std::vector<Metric>{constraint.metric};
    for (const std::size_t s : constraint.scenarios) {
      for (const Metric metric : metrics) {
        if (applies(metric, scenarios[s])) add_use(uses, {metric, s});
      }
    }
  }
  return uses;
}

}  // namespace armtune::internal
