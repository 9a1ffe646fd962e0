#pragma once
// Whether gains hold for other rotor inertia than the one that was estimated.

#include <atomic>

#include "core/control/gains.hpp"
#include "tuner/study/study.hpp"
#include "tuner/verdict/search_checks.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune::internal {

/// Adds the check that the loop holds, as Simbody judges it and as for a stability margin, in every scenario
/// whose robot has estimated rotor inertia: with the estimate divided by kRotorFactor, and with the estimate
/// times it. Adds nothing where nothing is estimated. Returns false if `stop` cut it short.
bool add_rotor_check(const Study& study, const Gains& gains, const DeepCheckOptions& options,
                     const std::atomic<bool>& stop, SimulationVerdict& verdict);

}  // namespace armtune::internal
