#pragma once
// The control law of robots that are commanded by streamed joint positions, such as UR robots under servoj.
// It is simulated to choose the parameters of the stream.

#include "core/control/laws/controller_kind.hpp"

namespace armtune::internal {

inline constexpr const char* kPositionStreaming = "position_streaming";

/// Makes the kind of this name. It sends the desired joint positions once in every control period. In the
/// robot, a servo makes a smooth motion q_s of them (position_servo.hpp), which a position loop and the
/// joints' velocity drives follow (joint_drives.hpp):
///   velocity command = q_s' + servo_position_gain (q_s - q).
/// The gains that are tuned are those of the servo, which a user of servoj can choose.
ControllerKind position_streaming_controller();

}  // namespace armtune::internal
