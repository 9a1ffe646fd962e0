#pragma once
// Serialises the messages of ROS 2 that describe the motion of an arm. Each function begins a new message and
// returns its bytes, which are valid until the next one is begun. Stamps are in ns and not negative.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/common/types.hpp"
#include "sim/logs/cdr_writer.hpp"

namespace armtune::internal {

/// The pose of a frame in another one.
struct FramePose {
  Mat3 R = Mat3::Identity();
  Vec3 p = Vec3::Zero();  ///< [m]
};

/// The pose of the frame `child` in the frame `parent`.
struct NamedTransform {
  std::string parent, child;
  FramePose pose;
};

/// Returns a sensor_msgs/JointState of the named joints [rad, m; /s; N m, N]. velocity and effort: one for
/// each joint, or empty.
std::span<const std::byte> joint_state_message(CdrWriter& out, std::int64_t stamp,
                                               const std::vector<std::string>& names,
                                               std::span<const double> position,
                                               std::span<const double> velocity,
                                               std::span<const double> effort);

/// Returns a geometry_msgs/PoseStamped: a pose in the frame of that name.
std::span<const std::byte> pose_message(CdrWriter& out, std::int64_t stamp, const std::string& frame,
                                        const FramePose& pose);

/// Returns a tf2_msgs/TFMessage.
std::span<const std::byte> tf_message(CdrWriter& out, std::int64_t stamp,
                                      const std::vector<NamedTransform>& transforms);

/// Returns a std_msgs/Float64.
std::span<const std::byte> float_message(CdrWriter& out, double value);

}  // namespace armtune::internal
