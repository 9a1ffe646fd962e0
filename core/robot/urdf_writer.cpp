#include "core/robot/urdf_writer.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&') {
      safe += "&amp;";
    } else if (c == '<') {
      safe += "&lt;";
    } else if (c == '"') {
      safe += "&quot;";
    } else {
      safe += c;
    }
  }
  return safe;
}

std::string numbers(const Vec3& v) {
  return fmt::format("{} {} {}", v.x(), v.y(), v.z());
}

/// Returns (roll, pitch, yaw) with R = Rz(yaw) Ry(pitch) Rx(roll).
Vec3 roll_pitch_yaw(const Mat3& R) {
  const double level = std::hypot(R(0, 0), R(1, 0));
  const double pitch = std::atan2(-R(2, 0), level);
  // At a pitch of 90 or -90 degrees, roll and yaw turn about the same axis. Roll is then set to zero.
  if (level < 1e-9) return {0.0, pitch, std::atan2(-R(0, 1), R(1, 1))};
  return {std::atan2(R(2, 1), R(2, 2)), pitch, std::atan2(R(1, 0), R(0, 0))};
}

std::string origin(const Mat3& R, const Vec3& p) {
  return fmt::format("<origin xyz=\"{}\" rpy=\"{}\"/>", numbers(p), numbers(roll_pitch_yaw(R)));
}

std::string inertial(const LinkInertia& link) {
  const Vec3 c = link.mass > 0.0 ? Vec3(link.first_moment / link.mass) : Vec3::Zero();
  const Mat3 I = link.inertia - link.mass * (c.squaredNorm() * Mat3::Identity() - c * c.transpose());
  return fmt::format(
      "    <inertial>\n      <origin xyz=\"{}\" rpy=\"0 0 0\"/>\n      <mass value=\"{}\"/>\n"
      "      <inertia ixx=\"{}\" ixy=\"{}\" ixz=\"{}\" iyy=\"{}\" iyz=\"{}\" izz=\"{}\"/>\n    </inertial>\n",
      numbers(c), link.mass, I(0, 0), I(0, 1), I(0, 2), I(1, 1), I(1, 2), I(2, 2));
}

std::string joint_text(const RobotModel& model, int i, const std::string& parent) {
  const auto k = static_cast<std::size_t>(i);
  const JointInfo& joint = model.joints[k];
  const JointLimits& limits = joint.limits;
  const char* type = model.chain.motion[k] == JointMotion::kPrismatic ? "prismatic"
                     : limits.has_position                            ? "revolute"
                                                                      : "continuous";
  const std::string position =
      limits.has_position ? fmt::format("lower=\"{}\" upper=\"{}\" ", limits.lower, limits.upper) : "";
  return fmt::format(
      "  <joint name=\"{}\" type=\"{}\">\n    <parent link=\"{}\"/>\n    <child link=\"{}\"/>\n    {}\n"
      "    <axis xyz=\"0 0 1\"/>\n    <limit {}velocity=\"{}\" effort=\"{}\"/>\n  </joint>\n",
      escaped(joint.name), type, escaped(parent), escaped(joint.link),
      origin(model.chain.R_PB0[k], model.chain.p_PB0[k]), position, limits.velocity, limits.effort);
}

/// Returns a name that no link of the model has, and for which no joint is called NAME_joint.
std::string free_link(const RobotModel& model, std::string name) {
  const auto taken = [&](const JointInfo& joint) {
    return joint.link == name || joint.name == name + "_joint";
  };
  while (name == model.base_link || std::any_of(model.joints.begin(), model.joints.end(), taken)) name += '_';
  return name;
}

std::string fixed_joint(const std::string& name, const std::string& parent, const std::string& child,
                        const std::string& placed) {
  return fmt::format(
      "  <joint name=\"{}\" type=\"fixed\">\n    <parent link=\"{}\"/>\n    <child link=\"{}\"/>\n    {}\n"
      "  </joint>\n",
      name, escaped(parent), escaped(child), placed);
}

/// Returns the text of an upright root link for a base link whose -z is not the direction of gravity. If
/// gravity is zero or acts along -z, no root link is needed and the text is empty.
std::string root_text(const RobotModel& model) {
  const Vec3& g = model.chain.gravity;
  if (g.isZero(0.0) || (g.normalized() + Vec3::UnitZ()).norm() < 1e-12) return {};
  const Mat3 R_root_0 = Eigen::Quaterniond::FromTwoVectors(g, -Vec3::UnitZ()).toRotationMatrix();
  const std::string root = free_link(model, "upright");
  return fmt::format("  <link name=\"{}\"/>\n", root) +
         fixed_joint(root + "_joint", root, model.base_link, origin(R_root_0, Vec3::Zero()));
}

}  // namespace

std::string urdf_tool_link(const RobotModel& model) {
  return free_link(model, "tool");
}

std::string urdf_text(const RobotModel& model) {
  std::string text = fmt::format("<?xml version=\"1.0\"?>\n<robot name=\"{}\">\n  <link name=\"{}\"/>\n",
                                 escaped(model.name), escaped(model.base_link));
  text += root_text(model);
  std::string parent = model.base_link;
  for (int i = 0; i < model.n(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    text += fmt::format("  <link name=\"{}\">\n{}  </link>\n", escaped(model.joints[k].link),
                        inertial(model.chain.link[k]));
    text += joint_text(model, i, parent);
    parent = model.joints[k].link;
  }
  const std::string tool = urdf_tool_link(model);
  text += fmt::format("  <link name=\"{}\"/>\n", tool);
  return text + fixed_joint(tool + "_joint", parent, tool, origin(model.chain.R_BT, model.chain.p_BT)) +
         "</robot>\n";
}

}  // namespace armtune::internal
