#include "tuner/planning/output/ros_trajectory.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/common/message_text.hpp"
#include "sim/yaml/quoted.hpp"

namespace armtune::internal {
namespace {

constexpr double kAtRest = 1e-6;  // largest velocity at rest, relative to the joint's limit

/// Returns a number with a point, such as "1.0e-05". YAML 1.1 reads "1e-05" as text and "0" as an integer.
std::string number(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find('.') == std::string::npos) text.insert(std::min(text.find('e'), text.size()), ".0");
  return text;
}

std::string list(const Eigen::MatrixXd& values, Eigen::Index n, Eigen::Index column) {
  std::string text = "[";
  for (Eigen::Index i = 0; i < n; ++i) text += (i == 0 ? "" : ", ") + number(values(i, column));
  return text + "]";
}

/// Returns a warning if the motion does not end at rest, else an empty text. It names the joint that moves
/// fastest at the end, relative to its velocity limit.
std::string end_velocity(const RobotModel& robot, const Trajectory& trajectory) {
  const Eigen::Index last = trajectory.velocity.cols() - 1;
  Eigen::Index fastest = 0;
  const Eigen::ArrayXd ratios =
      trajectory.velocity.col(last).head(robot.n()).array().abs() / robot.velocity_limits().array();
  if (!(ratios.maxCoeff(&fastest) > kAtRest)) return {};
  const auto joint = static_cast<std::size_t>(fastest);
  const bool turns = robot.chain.motion[joint] == JointMotion::kRevolute;
  return fmt::format(
      "The trajectory does not end at rest: {} still moves at {:.4g} {} there. Send it only if "
      "another motion follows without a pause. Otherwise a joint trajectory controller rejects it, or the arm "
      "stops abruptly at its end.",
      robot.joints[joint].name, trajectory.velocity(fastest, last), turns ? "rad/s" : "m/s");
}

}  // namespace

std::string ros_trajectory(const RobotModel& robot, const Trajectory& trajectory, RosVersion version,
                           const std::vector<std::string>& header) {
  std::string text;
  for (const std::string& line : header) text += yaml::comment(line);
  if (const std::string moving = end_velocity(robot, trajectory); !moving.empty())
    text += yaml::comment(moving);
  text += "joint_names:\n";
  for (const std::string& joint : joint_names(robot)) text += "  - " + yaml::quoted(joint) + "\n";
  text += "points:\n";
  const bool two = version == RosVersion::kRos2;
  constexpr long long kNanoseconds = 1'000'000'000;
  for (std::size_t k = 0; k < trajectory.time.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const long long nanoseconds = std::llround((trajectory.time[k] - trajectory.time.front()) * 1e9);
    text += "  - positions: " + list(trajectory.position, robot.n(), column) + "\n";
    text += "    velocities: " + list(trajectory.velocity, robot.n(), column) + "\n";
    text += "    accelerations: " + list(trajectory.acceleration, robot.n(), column) + "\n";
    text += fmt::format("    time_from_start: {{{}: {}, {}: {}}}\n", two ? "sec" : "secs",
                        nanoseconds / kNanoseconds, two ? "nanosec" : "nsecs", nanoseconds % kNanoseconds);
  }
  return text;
}

}  // namespace armtune::internal
