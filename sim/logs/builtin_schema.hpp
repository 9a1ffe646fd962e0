#pragma once
// Makes the schemas that bags hold for the built-in message types.

#include "sim/logs/bag.hpp"

namespace armtune::internal {

/// Returns a topic of CDR-encoded messages, with the complete schema of its type in the encoding "ros2msg":
/// the definition of the type, and of every type that it contains. type: such as
/// "sensor_msgs/msg/JointState". Throws InputError if it is not built in (builtin_definitions.hpp).
BagTopic builtin_topic(std::string name, const std::string& type);

}  // namespace armtune::internal
