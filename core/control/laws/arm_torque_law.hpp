#pragma once
// An adapter that uses a law for several arms (arm_law.hpp) as the law of a single arm.

#include <memory>
#include <vector>

#include "core/control/laws/arm_law.hpp"
#include "core/control/laws/torque_law.hpp"

namespace armtune::internal {

/// Returns the values that such a law starts with under these gains. own: storage for the pointers to the
/// controller's own gains. It, gains and theta must outlive the result.
LawNumbers law_numbers(const Gains& gains, const ParameterVector& theta, double period,
                       std::vector<const double*>& own);

std::unique_ptr<TorqueLaw> make_torque_law(ArmLawKind kind, const LawSetup& setup);

}  // namespace armtune::internal
