#pragma once
// Checks whether gains tolerate a rotor inertia that differs from its estimate. Robots whose data give no
// rotor inertia can have an estimate (rotor_estimate.hpp).

#include <atomic>

#include "core/control/gains.hpp"
#include "tuner/study/study.hpp"
#include "tuner/verdict/search_checks.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune::internal {

/// Adds a check that the loop is stable (margins.hpp) in every scenario whose robot has estimated rotor
/// inertia. Simbody simulates each of these scenarios twice: with the estimate divided by kRotorFactor, and
/// with the estimate multiplied by it. Adds nothing if no rotor inertia is estimated. Returns false if `stop`
/// interrupted the check.
bool add_rotor_check(const Study& study, const Gains& gains, const DeepCheckOptions& options,
                     const std::atomic<bool>& stop, SimulationVerdict& verdict);

}  // namespace armtune::internal
