#pragma once
// Compares the logged motion and torques with the limits of the robot file. A joint that is far outside its
// limits for much of a log suggests that the log has another unit, or is of
// another arm.

#include "core/robot/robot_model.hpp"
#include "tuner/identification/log_instants.hpp"

namespace armtune::internal {

/// Throws InputError if no joint's position varies by more than 0.01 rad or 0.01 m. Such a log contains
/// almost no information about masses.
void check_motion(const RobotModel& model, const std::vector<LogInstant>& instants, const std::string& logs);

/// Throws InputError if over 5 % of the instants have a position of more than three times the largest limit,
/// or a velocity or torque of more than twice its limit, or if a torque never changes, although the
/// joint moves by more than 0.01 rad or 0.01 m, or is always zero. The message names the
/// logs, the joint, the value, the limit and the likely unit.
void check_units(const RobotModel& model, const std::vector<LogInstant>& instants, const std::string& logs);

/// Throws InputError if over 5 % of the instants have a position outside its limits by more than a tenth of
/// the range.
void check_positions(const RobotModel& model, const std::vector<LogInstant>& instants,
                     const std::string& logs);

}  // namespace armtune::internal
