#pragma once
// Whether gains also do for arms that differ from the model, before they are anyone's first gains.

#include "core/control/gains.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

inline constexpr int kOtherArms = 60;

/// How many of them may lose a limit: half the share that a verdict allows, as a search comes closer to the
/// limits.
int most_lost_arms();

/// Whether all of kOtherArms arms at random keep their limits in the scenario, but for most_lost_arms();
/// torque may saturate in 1 % of the periods, as in a verdict. They are none of those that the study or its
/// verdict simulates. In armtune's own dynamics; workers: threads (>= 1).
bool nearly_all_hold(const Scenario& scenario, const Gains& gains, int workers);

}  // namespace armtune::internal
