#pragma once
// Tests first gains on random arms that differ from the model.

#include "core/control/gains.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

inline constexpr int kOtherArms = 60;

/// Returns how many of these arms may break a limit. It is half the share that a verdict allows, because a
/// search brings the arm closer to its limits.
int most_lost_arms();

/// True if all but most_lost_arms() of kOtherArms random arms keep their limits in the scenario. Torque may
/// saturate in 1 % of the periods, as in a verdict. The arms are others than those that the study or its
/// verdict simulates. They are simulated in armtune's own dynamics. workers: threads (>= 1).
bool nearly_all_hold(const Scenario& scenario, const Gains& gains, int workers);

}  // namespace armtune::internal
