#pragma once
// Checks whether gains tolerate rotor inertia that differs from the estimate.

#include <atomic>

#include "core/control/gains.hpp"
#include "tuner/study/study.hpp"
#include "tuner/verdict/search_checks.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune::internal {

/// Adds a check that the loop holds, in the sense of a stability margin and simulated in Simbody, in every
/// scenario whose robot has estimated rotor inertia. It is tested with the estimate divided by kRotorFactor
/// and multiplied by it. Adds nothing if no inertia is estimated. Returns false if `stop` interrupted it.
bool add_rotor_check(const Study& study, const Gains& gains, const DeepCheckOptions& options,
                     const std::atomic<bool>& stop, SimulationVerdict& verdict);

}  // namespace armtune::internal
