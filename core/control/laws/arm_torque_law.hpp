#pragma once
// Adapts a law that is a template for one or several arms (arm_law.hpp) for use as the torque law of one arm
// (torque_law.hpp).

#include <memory>
#include <optional>
#include <vector>

#include "core/control/laws/arm_law.hpp"
#include "core/control/laws/jtc_command.hpp"
#include "core/control/laws/torque_law.hpp"

namespace armtune::internal {

/// Storage for the numbers to which LawNumbers points.
struct LawStorage {
  std::vector<const double*> own;
  JtcNumbers joint_trajectory;
};

/// Returns the start values of the law that `setup` describes. storage, and the gains and theta to which
/// setup refers, must outlive the result.
LawNumbers law_numbers(const LawSetup& setup, LawStorage& storage);

/// Returns the drives that a law of this kind commands, or nothing if it commands torques.
std::optional<JointDrives> make_drives(ArmLawKind kind, const LawSetup& setup);

std::unique_ptr<TorqueLaw> make_torque_law(ArmLawKind kind, const LawSetup& setup);

}  // namespace armtune::internal
