#include "sim/logs/ros_messages.hpp"

#include <initializer_list>

namespace armtune::internal {
namespace {

/// Writes a std_msgs/Header.
void add_header(CdrWriter& out, std::int64_t stamp, const std::string& frame) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  out.number(static_cast<std::int32_t>(stamp / kSecond));
  out.number(static_cast<std::uint32_t>(stamp % kSecond));
  out.string(frame);
}

/// Writes a geometry_msgs/Pose or Transform, which have the same fields.
void add_pose(CdrWriter& out, const FramePose& pose) {
  const Eigen::Quaterniond q(pose.R);
  for (const double value : {pose.p.x(), pose.p.y(), pose.p.z(), q.x(), q.y(), q.z(), q.w()})
    out.number(value);
}

}  // namespace

std::span<const std::byte> joint_state_message(CdrWriter& out, std::int64_t stamp,
                                               const std::vector<std::string>& names,
                                               std::span<const double> position,
                                               std::span<const double> velocity,
                                               std::span<const double> effort) {
  add_header(out.begin(), stamp, "");
  out.length(names.size());
  for (const std::string& name : names) out.string(name);
  return out.numbers(position).numbers(velocity).numbers(effort).bytes();
}

std::span<const std::byte> pose_message(CdrWriter& out, std::int64_t stamp, const std::string& frame,
                                        const FramePose& pose) {
  add_header(out.begin(), stamp, frame);
  add_pose(out, pose);
  return out.bytes();
}

std::span<const std::byte> tf_message(CdrWriter& out, std::int64_t stamp,
                                      const std::vector<NamedTransform>& transforms) {
  out.begin().length(transforms.size());
  for (const NamedTransform& transform : transforms) {
    add_header(out, stamp, transform.parent);
    out.string(transform.child);
    add_pose(out, transform.pose);
  }
  return out.bytes();
}

std::span<const std::byte> float_message(CdrWriter& out, double value) {
  return out.begin().number(value).bytes();
}

}  // namespace armtune::internal
