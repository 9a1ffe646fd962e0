#pragma once
// The control law of robots that are commanded by streamed joint positions, such as UR robots under servoj.
// armtune simulates it to tune the parameters that a user can choose, such as the gain and the look-ahead
// time of servoj.

#include "core/control/laws/controller_kind.hpp"

namespace armtune::internal {

inline constexpr const char* kPositionStreaming = "position_streaming";

/// Makes the kind of controller `position_streaming`. It sends the desired joint positions once in every
/// control period. In the robot, a servo turns them into a smooth motion q_s (position_servo.hpp), which a
/// position loop and the joints' velocity drives follow (joint_drives.hpp):
///   velocity command = q_s' + servo_position_gain * (q_s - q).
/// The gains that are tuned are those of the servo, which a user of servoj can choose.
ControllerKind position_streaming_controller();

}  // namespace armtune::internal
