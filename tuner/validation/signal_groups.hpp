#pragma once
// The groups of channels in a log that have one number for each joint of an arm, such as its positions.

#include <optional>
#include <string>
#include <vector>

#include "sim/logs/log.hpp"
#include "sim/logs/log_meaning.hpp"
#include "tuner/validation/joint_channels.hpp"

namespace armtune::internal {

struct SignalGroup {
  std::string topic;
  std::string name;  ///< of the group, for people
  Quantity quantity = Quantity::kUnknown;
  Role role = Role::kMeasured;
  Sureness sureness = Sureness::kNone;
  std::string unit;
  JointMatch match = JointMatch::kName;
  std::vector<std::string> channels;  ///< n, names of the channels
  std::vector<double> scale;          ///< n, factors to SI
};

/// Returns the groups of positions, velocities, torques and currents of all joints, in the order of the log.
/// Positions whose unit is not stated are in degrees if they look so and exceed the limits of the joints as
/// radians.
std::vector<SignalGroup> signal_groups(const RobotModel& model, const LogSummary& summary);

/// Returns the first group with the quantity and role that the values do not contradict; if there is none,
/// the first one; null if there is none at all. topic: empty: of any topic.
const SignalGroup* find_group(const std::vector<SignalGroup>& groups, Quantity quantity, Role role,
                              const std::string& topic = {});

/// Returns a clause about the group, such as "/joint_states/position[0..5] in deg, converted to rad".
std::string to_text(const SignalGroup& group);

/// Returns what the channels of a log look like, for messages: "positions (/joint_states/position[0..5]),
/// ...".
std::string listed_groups(const LogSummary& summary);

}  // namespace armtune::internal
