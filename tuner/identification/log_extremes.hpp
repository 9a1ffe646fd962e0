#pragma once
// How the logged motion and torques compare with the limits of the robot file: whoever sees a joint far
// outside its limits for much of a log looks at another unit or at another arm.

#include "core/robot/robot_model.hpp"
#include "tuner/identification/log_instants.hpp"

namespace armtune::internal {

/// Throws InputError that names the logs, the joint, the value, the limit and the likely unit where over 5 %
/// of the instants have a position of more than three times the largest limit, or a velocity or torque of
/// more than twice its limit, or where a torque is always zero.
void check_units(const RobotModel& model, const std::vector<LogInstant>& instants, const std::string& logs);

/// Throws InputError where over 5 % of the instants have a position more than a tenth of the range outside
/// its limits.
void check_positions(const RobotModel& model, const std::vector<LogInstant>& instants,
                     const std::string& logs);

}  // namespace armtune::internal
