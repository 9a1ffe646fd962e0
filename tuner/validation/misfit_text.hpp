#pragma once
// Sentences about how well the unfitted model explains a joint's torque, and why it does not.

#include <string>

#include "tuner/validation/misfit_cause.hpp"

namespace armtune::internal {

/// Returns one clause with the size of the cause and its unit, such as "the residual follows the sign of the
/// velocity, so Coulomb friction of about 1.2 N m is missing".
std::string to_text(const MisfitCause& cause, const RobotModel& model);

/// Returns one sentence for a joint, without a full stop: its name, the share of its torque's variance that
/// is explained, and the causes that explain at least `least_share` of its residual, such as "wrist_3_joint:
/// 61 % explained; the residual follows ...".
std::string joint_text(const RobotModel& model, int joint, const JointResidual& residual,
                       const Misfit& misfit, double least_share);

}  // namespace armtune::internal
