#pragma once
// The distributions of ROS whose joint_trajectory_controller armtune simulates, and the rules in which they
// differ. The gain jtc_distro is the index of a distribution in kRosRules. Sources, at these commits:
//   jazzy:  ros2_controllers ed360c9 (4.42.1), control_toolbox 05de3c6 (4.11.0);
//   humble: ros2_controllers ad559d9 (2.54.0), control_toolbox 01a3ded (3.7.0);
//   noetic: ros_controllers 678b92a (0.21.2), control_toolbox de05a5c (1.19.0).

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace armtune::internal {

enum class RosDistro { kJazzy, kHumble, kNoetic };

/// The joints whose position error is wrapped to -pi .. pi.
enum class Wraparound {
  kWithoutLimits,  ///< the continuous joints of the URDF
  kAsParameter,    ///< those with the parameter angle_wraparound
  kAll
};

struct RosRules {
  std::string_view name;   ///< as users write it
  std::string_view title;  ///< for messages
  bool ros2;               ///< true: its parameter files are those of ROS 2
  /// True: the feed-forward takes the desired velocity of the next period. False: of this period.
  bool feeds_next_velocity;
  Wraparound wraparound;
  /// True: without a parameter there is no bound on the integral. False: the bound is then 0.
  bool unbounded_by_default;
  bool has_bounds_of_integral;  ///< has the parameters i_clamp_min and i_clamp_max beside i_clamp
  /// True: there are the parameters u_clamp_max, u_clamp_min, antiwindup_strategy, tracking_time_constant and
  /// error_deadband.
  bool has_strategies;
};

inline constexpr std::array<RosRules, 3> kRosRules = {{
    {"jazzy", "ROS 2 Jazzy", true, true, Wraparound::kWithoutLimits, true, true, true},
    {"humble", "ROS 2 Humble", true, false, Wraparound::kAsParameter, false, false, false},
    {"noetic", "ROS 1 Noetic", false, false, Wraparound::kAll, false, true, false},
}};

constexpr const RosRules& rules_of(RosDistro distro) {
  return kRosRules[static_cast<std::size_t>(distro)];
}

/// Returns the distribution of that name (RosRules::name), or nothing if there is none.
constexpr std::optional<RosDistro> distro_from_name(std::string_view name) {
  for (std::size_t k = 0; k < kRosRules.size(); ++k) {
    if (kRosRules[k].name == name) return static_cast<RosDistro>(k);
  }
  return std::nullopt;
}

}  // namespace armtune::internal
