#pragma once
// Where a study's constraint is broken first: the joint and the time that a metric's value alone does not
// tell.

#include <optional>
#include <string>

#include "sim/rollout/end_limit.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {

struct Breach {
  std::string arm;    ///< of several, such as "random arm 3 of 6"; empty where the study has one
  std::string joint;  ///< empty for metrics that are no joint's
  double time = 0.0;  ///< [s]
};

/// Simulates the scenario, on every arm of the study, in the native engine (with the stepper `reference` in
/// Simbody) until the metric is beyond the limit, and returns the earliest breach. None if no arm breaks it
/// in that engine, or for a metric whose value is not known before a rollout's end.
std::optional<Breach> first_breach(const Study& study, const Scenario& scenario, const Gains& gains,
                                   const EndLimit& limit);

}  // namespace armtune::internal
