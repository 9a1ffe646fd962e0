#pragma once
// Compares the rollouts of a run with the best motions that the arm's limits allow, at the end of that run's
// own session (the option --yardstick of `armtune tune` and `armtune simulate`).

#include "tuner/planning/session/rollout_measures.hpp"
#include "tuner/session/yardstick_files.hpp"

namespace armtune::internal {

/// Compares the rollouts in the folder with the best motions, and writes yardstick.csv there (see Yardstick).
/// Never throws but only warns, because the run itself is finished. If `stop` becomes true, it writes only
/// yardstick.csv, with the events that are finished.
YardstickFiles add_yardstick(const std::string& folder, const std::vector<Scenario>& scenarios,
                             const GainsOf& gains, const std::atomic<bool>& stop,
                             YardstickObserver& observer);

}  // namespace armtune::internal
