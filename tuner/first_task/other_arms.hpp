#pragma once
// Tests gains on random arms, whose parameters differ from those of the arm's model. The gains that armtune
// proposes for a first task must pass this test.

#include "core/control/gains.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

inline constexpr int kOtherArms = 60;  ///< number of random arms in the test

/// Returns how many of the kOtherArms random arms may break a limit. The share is half of what the final
/// checks of a tuning allow, because the search that follows brings the arm closer to its limits.
int most_lost_arms();

/// True if at most most_lost_arms() of kOtherArms random arms break a limit in the scenario. Torque may
/// saturate in at most 1 % of the control periods, as in the final checks. The arms differ from those that
/// the study or its final checks simulate. They are simulated in armtune's own dynamics. workers: number of
/// threads (>= 1).
bool nearly_all_hold(const Scenario& scenario, const Gains& gains, int workers);

}  // namespace armtune::internal
