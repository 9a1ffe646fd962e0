#include "core/robot/urdf_reader.hpp"

#include <console_bridge/console.h>
#include <fmt/format.h>
#include <urdf_parser/urdf_parser.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <memory>
#include <mutex>

#include "armtune/error.hpp"
#include "core/robot/urdf_arm.hpp"
#include "core/robot/urdf_rotors.hpp"
#include "core/robot/urdf_shapes.hpp"
#include "core/robot/xml_guard.hpp"

namespace armtune::internal {
namespace {

/// Collects the errors that urdfdom logs while this object lives. After many of them, urdfdom nevertheless
/// returns a model, with zeros in it.
class ErrorLog : public console_bridge::OutputHandler {
 public:
  ErrorLog() : handler_(console_bridge::getOutputHandler()), level_(console_bridge::getLogLevel()) {
    console_bridge::useOutputHandler(this);
    console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_ERROR);
  }
  ErrorLog(const ErrorLog&) = delete;
  ErrorLog& operator=(const ErrorLog&) = delete;
  ~ErrorLog() override {
    // Twice: console_bridge remembers the previous handler too, and that must not be this object.
    console_bridge::useOutputHandler(handler_);
    console_bridge::useOutputHandler(handler_);
    console_bridge::setLogLevel(level_);
  }
  void log(const std::string& text, console_bridge::LogLevel, const char*, int) override { add(text); }

  void add(const std::string& text) { text_ += (text_.empty() ? "" : "; ") + text; }
  /// Returns the errors on one line, cut to 1000 bytes; empty if there was none.
  std::string line() const {
    std::string line = text_.substr(0, 1000);
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return line;
  }

 private:
  console_bridge::OutputHandler* handler_;
  console_bridge::LogLevel level_;
  std::string text_;
};

using Parsed = std::shared_ptr<const urdf::ModelInterface>;

Parsed parse(const std::string& text, const std::string& path) {
  static std::mutex one_at_a_time;  // console_bridge has one handler per process
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  ErrorLog log;
  urdf::ModelInterfaceSharedPtr parsed;
  try {
    parsed = urdf::parseURDF(text);
  } catch (const std::exception& error) {
    log.add(error.what());
  }
  // Links own their children. They are separated here: otherwise a cycle would never be freed, and a long
  // chain would be freed by deep recursion.
  Parsed tree(parsed.get(), [parsed](const urdf::ModelInterface*) {
    if (!parsed) return;
    for (const auto& [name, link] : parsed->links_) link->clear();
  });
  if (const std::string errors = log.line(); !errors.empty())
    throw InputError(InputPlace{path}, fmt::format("{}; correct the file", errors));
  if (!parsed || !parsed->getRoot())
    throw InputError(InputPlace{path}, "contains no robot that urdfdom can read");
  return tree;
}

Vec3 position(const urdf::Pose& pose) {
  return {pose.position.x, pose.position.y, pose.position.z};
}

Mat3 rotation(const urdf::Pose& pose) {
  const urdf::Rotation& q = pose.rotation;
  return Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
}

UrdfMotion motion_of(const urdf::Joint& joint) {
  switch (joint.type) {
    case urdf::Joint::FIXED:
      return UrdfMotion::kFixed;
    case urdf::Joint::REVOLUTE:
      return UrdfMotion::kRevolute;
    case urdf::Joint::CONTINUOUS:
      return UrdfMotion::kContinuous;
    case urdf::Joint::PRISMATIC:
      return UrdfMotion::kPrismatic;
    default:
      return UrdfMotion::kOther;
  }
}

/// Narrows the limits to the soft limits, within which the joint's safety controller keeps the joint.
void narrow(const urdf::JointSafety& safety, UrdfJoint::Limits& limits) {
  const double lower = std::max(limits.lower, safety.soft_lower_limit);
  const double upper = std::min(limits.upper, safety.soft_upper_limit);
  if (!(safety.soft_lower_limit < safety.soft_upper_limit) || !(lower < upper)) return;
  limits.soft = lower > limits.lower || upper < limits.upper;
  limits.lower = lower;
  limits.upper = upper;
}

UrdfJoint joint_of(const urdf::Joint& from) {
  UrdfJoint joint;
  joint.name = from.name;
  joint.motion = motion_of(from);
  joint.parent = from.parent_link_name;
  joint.child = from.child_link_name;
  joint.R_PL = rotation(from.parent_to_joint_origin_transform);
  joint.p_PL = position(from.parent_to_joint_origin_transform);
  joint.axis = Vec3(from.axis.x, from.axis.y, from.axis.z);
  if (from.limits) {
    joint.limits = {from.limits->lower, from.limits->upper, from.limits->velocity, from.limits->effort};
    if (from.safety && joint.motion != UrdfMotion::kContinuous) narrow(*from.safety, *joint.limits);
  }
  if (from.dynamics) {
    joint.damping = from.dynamics->damping;
    joint.friction = from.dynamics->friction;
  }
  if (from.mimic) joint.mimics = from.mimic->joint_name;
  return joint;
}

UrdfLink link_of(const urdf::Link& from) {
  UrdfLink link;
  link.name = from.name;
  if (from.inertial) {
    const urdf::Inertial& given = *from.inertial;
    UrdfInertial& inertial = link.inertial.emplace();
    inertial.mass = given.mass;
    inertial.R_LC = rotation(given.origin);
    inertial.p_LC = position(given.origin);
    inertial.about_center << given.ixx, given.ixy, given.ixz,  //
        given.ixy, given.iyy, given.iyz,                       //
        given.ixz, given.iyz, given.izz;
  }
  link.shapes = shapes_of(from);
  for (const auto& joint : from.child_joints) link.joints.push_back(joint->name);
  return link;
}

UrdfTree read_tree(const std::string& path) {
  const std::string text = read_guarded_urdf(path);
  const Parsed parsed = parse(text, path);
  UrdfTree tree{parsed->getName(), parsed->getRoot()->name, {}, {}};
  for (const auto& [name, link] : parsed->links_) tree.links.emplace(name, link_of(*link));
  for (const auto& [name, joint] : parsed->joints_) tree.joints.emplace(name, joint_of(*joint));
  for (auto& [name, interfaces] : ros2_control_interfaces(text)) {
    if (const auto joint = tree.joints.find(name); joint != tree.joints.end())
      joint->second.interfaces = std::move(interfaces);
  }
  for (const auto& [name, inertia] : rotor_inertias(text, path)) {
    if (const auto joint = tree.joints.find(name); joint != tree.joints.end())
      joint->second.rotor_inertia = inertia;
  }
  return tree;
}

}  // namespace

RobotModel read_urdf(const std::string& path, const UrdfOptions& options, MissingData* missing) {
  return build_arm(read_tree(path), options, path, missing);
}

MissingData missing_data(const std::string& path, const UrdfOptions& options) {
  MissingData missing;
  read_urdf(path, options, &missing);
  return missing;
}

}  // namespace armtune::internal
