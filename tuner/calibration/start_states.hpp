#pragma once
// The state of an arm at the start of a window, as the log shows it.

#include "tuner/calibration/shooting.hpp"

namespace armtune::internal {

/// Returns the state at the first sample of a window: positions and velocities of a cubic polynomial through
/// the samples within 50 ms, from the first sample of the log on, or, with only_after, from that of the
/// window on. The integrals of drives are those with which the arm has the acceleration of the polynomial.
StartState logged_start(const JointLog& log, const LogWindow& window, const ShootingArm& arm,
                        CommandKind kind, const StepCommands& commands, bool only_after);

/// The standard deviations of the difference between the true state and that of logged_start(), as a prior
/// (n).
StartState start_deviations(const RobotModel& model, const Eigen::VectorXd& encoder_noise);

}  // namespace armtune::internal
