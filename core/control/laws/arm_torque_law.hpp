#pragma once
// Adapts a law that is a template for one or several arms (arm_law.hpp) for use as the torque law of one arm
// (torque_law.hpp).

#include <memory>
#include <vector>

#include "core/control/laws/arm_law.hpp"
#include "core/control/laws/torque_law.hpp"

namespace armtune::internal {

/// Returns the start values of such a law for these gains. own: storage for pointers to the gains that only
/// this kind of controller has. own, gains and theta must outlive the result.
LawNumbers law_numbers(const Gains& gains, const ParameterVector& theta, double period,
                       std::vector<const double*>& own);

std::unique_ptr<TorqueLaw> make_torque_law(ArmLawKind kind, const LawSetup& setup);

}  // namespace armtune::internal
