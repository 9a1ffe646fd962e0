#pragma once
// A law that is written for several arms, as the law of one.

#include <memory>
#include <vector>

#include "core/control/laws/arm_law.hpp"
#include "core/control/laws/torque_law.hpp"

namespace armtune::internal {

/// What such a law begins with under these gains. own: room for as many pointers as the controller has own
/// gains; it and gains and theta outlive the result.
LawNumbers law_numbers(const Gains& gains, const ParameterVector& theta, double period,
                       std::vector<const double*>& own);

std::unique_ptr<TorqueLaw> make_torque_law(ArmLawKind kind, const LawSetup& setup);

}  // namespace armtune::internal
