#pragma once
// Compares the logged motion and torques with the limits of the robot file. A joint that is far outside its
// limits for much of a log suggests that the log is in another unit or of another arm.

#include "core/robot/robot_model.hpp"
#include "tuner/identification/log_instants.hpp"

namespace armtune::internal {

/// Throws InputError if no joint's position varies by more than 0.01 rad or 0.01 m. Such a log contains
/// almost no information about masses.
void check_motion(const RobotModel& model, const std::vector<LogInstant>& instants, const std::string& logs);

/// Throws InputError in each of these cases:
///   - over 5 % of the instants have a position of more than three times the largest limit;
///   - over 5 % of the instants have a velocity or a torque of more than twice its limit;
///   - a torque is always zero;
///   - a torque never changes, although the joint moves by more than 0.01 rad or 0.01 m.
/// The message names the logs and the joint. If a limit is exceeded, it also names the value, the limit and,
/// if possible, the likely unit.
void check_units(const RobotModel& model, const std::vector<LogInstant>& instants, const std::string& logs);

/// Throws InputError if over 5 % of the instants have a position outside its limits by more than a tenth of
/// the range.
void check_positions(const RobotModel& model, const std::vector<LogInstant>& instants,
                     const std::string& logs);

}  // namespace armtune::internal
