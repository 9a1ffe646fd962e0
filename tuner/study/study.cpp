#include "tuner/study/study.hpp"

namespace armtune::internal {

std::vector<Scenario> simulated_scenarios(const Study& study) {
  std::vector<Scenario> all = study.scenarios;
  for (const MarginDemand& demand : study.margins) {
    for (const Scenario& scenario : study.scenarios) all.push_back(corner_of(scenario, demand));
  }
  return all;
}

std::size_t results_per_evaluation(const Study& study) {
  return study.scenarios.size() * (1 + study.margins.size());
}

std::size_t rollouts_per_evaluation(const Study& study) {
  const std::size_t each = study.robust ? arms(*study.robust) : 1;
  return study.scenarios.size() * (each + study.margins.size());
}

}  // namespace armtune::internal
