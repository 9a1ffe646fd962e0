#pragma once
// Compares the sizes of measured and predicted torques. Arms of one family have similar geometry and very
// different masses. So the torques of one follow those that the robot file of another predicts, but are all
// smaller or all larger.

#include "tuner/validation/misfit_cause.hpp"

namespace armtune::internal {

/// Returns the slope of every joint's measured torque over the predicted one (n). Friction, rotor inertia and
/// a constant offset that the model lacks are fitted beside it. 1: the model is right.
JointVector torque_slopes(const TorqueRows& rows, const ValidationThresholds& thresholds = {});

/// Returns true if the torques suggest an arm of other masses: at least two of the joints that bear a load
/// (`loaded`), and at least half of them, do not match and have slopes below `other_arm`, or at least two and
/// half have slopes above its reciprocal. A payload makes slopes larger, too. So the second is only believed
/// if the misfit has no payload as a cause, or one of more than half of the arm's own mass.
bool suggests_another_arm(const RobotModel& model, const TorqueRows& rows, const Misfit& misfit,
                          const std::vector<bool>& matches, const ValidationThresholds& thresholds = {});

}  // namespace armtune::internal
