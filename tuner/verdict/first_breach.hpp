#pragma once
// Finds at which joint and at which time a study's constraint is first broken. The value of the metric does
// not show this.

#include <optional>
#include <string>

#include "sim/rollout/end_limit.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {

struct Breach {
  std::string arm;    ///< such as "random arm 3 of 6"; empty if the study has one arm
  std::string joint;  ///< empty if the metric belongs to no joint
  double time = 0.0;  ///< [s]
};

/// Simulates the scenario with every arm of the study until the metric reaches the limit, and returns the
/// earliest breach. The engine is armtune's own (native), or Simbody if the study's stepper is `reference`.
/// Returns nothing if no arm breaks the limit in that engine, or if the metric can improve again during a
/// rollout.
std::optional<Breach> first_breach(const Study& study, const Scenario& scenario, const Gains& gains,
                                   const EndLimit& limit);

}  // namespace armtune::internal
