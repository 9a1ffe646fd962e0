#pragma once
// Definitions of common message types, for bags that hold no schema: rosbag2 stores none in SQLite files
// before ROS 2 Iron. They have the fields of the published packages common_interfaces, control_msgs,
// geometry2 and rcl_interfaces, in the same order, without their comments.

#include <span>
#include <string_view>

namespace armtune::internal {

/// Returns the possible definitions of the type "PACKAGE/TYPE" in the .msg format, the newest first. There
/// are several if fields were added or renamed between ROS distributions. Empty: the type is not built in.
std::span<const std::string_view> builtin_definitions(std::string_view type);

}  // namespace armtune::internal
