#pragma once
// Units that the published message types of ROS 2 state in their comments (REP 103: SI units).

#include <string_view>

namespace armtune::internal {

/// Returns the unit of a field of the type "PACKAGE/TYPE", which holds for all numbers in the field; empty if
/// the type does not state one. Types that serve revolute and prismatic joints, such as JointState, do not.
std::string_view unit_of(std::string_view type, std::string_view field);

}  // namespace armtune::internal
