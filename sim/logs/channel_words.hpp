#pragma once
// Recognises in the name of a channel which quantity it is, and in which unit.

#include <string>
#include <string_view>
#include <vector>

namespace armtune::internal {

enum class Quantity {
  kUnknown,
  kPosition,      ///< of joints
  kVelocity,      ///< of joints
  kAcceleration,  ///< of joints
  kTorque,        ///< or force of joints
  kCurrent,       ///< of motors
  kDrive,         ///< torques or currents, it is not known which
  kTool,          ///< pose, velocity or force of the tool
  kOther,         ///< anything else that is recognised, such as temperatures, voltages, errors
};

enum class Role {
  kMeasured,
  kCommand,  ///< a desired value, a reference or a command
};

/// Returns the name of a quantity, such as "positions".
const char* plural(Quantity quantity);

struct ChannelWords {
  Quantity quantity = Quantity::kUnknown;
  Role role = Role::kMeasured;
  bool effort = false;  ///< called effort: some drivers publish currents under this name
  std::string unit;     ///< as the name states it, such as "deg"; empty: not stated
};

/// Recognises the words of a name: those of RTDE recorders (actual_q_0, target_moment_3), of libfranka
/// (state.tau_J[0], control.tau_J_d[0]), of ROS messages (position[0], effort[2], desired/positions[1]) and
/// plain ones (q1, dq1, tau1, "elbow velocity [deg/s]").
ChannelWords words_of(std::string_view name);

/// Does the same for the channel of a bag. If its field says nothing, the words of its topic are used, as in
/// /forward_position_controller/commands/data[0].
ChannelWords words_of(std::string_view name, std::string_view topic);

/// Returns a unit in its usual symbol: "rad" for radians, "deg" for degree, "N m" for Nm and so on. Returns
/// an empty text for other text.
std::string usual_unit(std::string_view text);

}  // namespace armtune::internal
