#include "core/robot/urdf_reader.hpp"

#include <console_bridge/console.h>
#include <fmt/format.h>
#include <urdf_parser/urdf_parser.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "core/common/error.hpp"
#include "core/robot/urdf_shapes.hpp"
#include "core/robot/xml_guard.hpp"

namespace armtune {
namespace {

/// Collects what urdfdom logs as errors while it lives: urdfdom returns a model with zeros for many of them.
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
  /// All errors on one line; empty if there was none.
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

using UrdfTree = std::shared_ptr<const urdf::ModelInterface>;

UrdfTree parse(const std::string& path) {
  const std::string text = read_guarded_urdf(path);
  static std::mutex one_at_a_time;  // console_bridge has one handler per process
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  ErrorLog log;
  urdf::ModelInterfaceSharedPtr parsed;
  try {
    parsed = urdf::parseURDF(text);
  } catch (const std::exception& error) {
    log.add(error.what());
  }
  // Links own their children: cut them apart, or a cycle is never freed and a long chain by deep recursion.
  UrdfTree tree(parsed.get(), [parsed](const urdf::ModelInterface*) {
    if (!parsed) return;
    for (const auto& [name, link] : parsed->links_) link->clear();
  });
  if (const std::string errors = log.line(); !errors.empty())
    throw InputError(fmt::format("{}: {}; correct the file", path, errors));
  if (!parsed || !parsed->getRoot()) throw InputError(path + ": urdfdom finds no robot in it");
  return tree;
}

Vec3 position(const urdf::Pose& pose) {
  return {pose.position.x, pose.position.y, pose.position.z};
}

Mat3 rotation(const urdf::Pose& pose) {
  const urdf::Rotation& q = pose.rotation;
  return Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
}

/// R_CB: the smallest rotation that takes z onto the unit vector `axis`; onto -z, a half turn about x.
Mat3 z_onto(const Vec3& axis) {
  const double sine_squared = axis.x() * axis.x() + axis.y() * axis.y();
  if (axis.z() < 0.0 && sine_squared < 1e-24) return Vec3(1.0, -1.0, -1.0).asDiagonal();
  // 1 + cos, in the form that does not cancel near -z.
  const double w = axis.z() < 0.0 ? sine_squared / (1.0 - axis.z()) : 1.0 + axis.z();
  return Eigen::Quaterniond(w, -axis.y(), axis.x(), 0.0).normalized().toRotationMatrix();
}

/// Where a link's frame L sits: fixed in the frame B of a moving body, or in the base (body -1).
struct Site {
  int body = -1;
  Mat3 R_BL = Mat3::Identity();
  Vec3 p_BL = Vec3::Zero();
};

class ArmBuilder {
 public:
  explicit ArmBuilder(const std::string& path) { model_.source = path; }

  RobotModel build(const urdf::ModelInterface& tree, const UrdfOptions& options) {
    model_.name = tree.getName();
    model_.base_link = tree.getRoot()->name;
    place_links(tree);
    if (model_.n() > 0) place_tool(options);
    validate(model_);
    return std::move(model_);
  }

 private:
  template <typename... Args>
  [[noreturn]] void refuse(fmt::format_string<Args...> text, Args&&... args) const {
    throw InputError(model_.source + ": " + fmt::format(text, std::forward<Args>(args)...));
  }

  /// Visits every link once, from the root outwards.
  void place_links(const urdf::ModelInterface& tree) {
    std::vector<const urdf::Link*> open{tree.getRoot().get()};
    sites_.emplace(open.back()->name, Site{});
    while (!open.empty()) {
      const urdf::Link& link = *open.back();
      open.pop_back();
      const Site site = sites_.at(link.name);
      if (site.body >= 0 && link.inertial) add_inertia(link, site);
      append_shapes(link, site.body, site.R_BL, site.p_BL, model_.shapes);
      for (std::size_t i = 0; i < link.child_joints.size(); ++i) {
        const urdf::Joint& joint = *link.child_joints[i];
        const urdf::Link& child = *link.child_links[i];
        if (sites_.contains(child.name))
          refuse("link '{}': joint '{}' leads to it a second time; links and joints must form a tree",
                 child.name, joint.name);
        sites_.emplace(child.name, add_joint(joint, site));
        open.push_back(&child);
      }
    }
    for (const auto& [name, link] : tree.links_)
      if (!sites_.contains(name))
        refuse("link '{}': no joints lead to it from the root link '{}'; is it part of a loop?", name,
               model_.base_link);
  }

  /// The site of the joint's child link; a moving joint starts a new body.
  Site add_joint(const urdf::Joint& joint, const Site& parent) {
    const urdf::Pose& origin = joint.parent_to_joint_origin_transform;
    const Mat3 R_PL = parent.R_BL * rotation(origin);
    const Vec3 p_PL = parent.p_BL + parent.R_BL * position(origin);
    if (joint.type == urdf::Joint::FIXED) return {parent.body, R_PL, p_PL};
    require_supported(joint, parent);

    Vec3 axis(joint.axis.x, joint.axis.y, joint.axis.z);
    const double length = axis.norm();
    if (!std::isfinite(length) || length < 1e-9)
      refuse("joint '{}': axis '{} {} {}' has no direction; give it a unit vector", joint.name, axis.x(),
             axis.y(), axis.z());
    axis /= length;

    Chain& chain = model_.chain;
    const int i = chain.n++;
    const auto k = static_cast<std::size_t>(i);
    const Mat3 R_LB = z_onto(axis);
    const bool prismatic = joint.type == urdf::Joint::PRISMATIC;
    chain.motion[k] = prismatic ? JointMotion::kPrismatic : JointMotion::kRevolute;
    chain.R_PB0[k] = R_PL * R_LB;
    chain.p_PB0[k] = p_PL;
    chain.rotor_inertia.conservativeResize(chain.n);
    chain.viscous_friction.conservativeResize(chain.n);
    chain.coulomb_friction.conservativeResize(chain.n);
    chain.rotor_inertia[i] = 0.0;
    chain.viscous_friction[i] = joint.dynamics ? joint.dynamics->damping : 0.0;
    chain.coulomb_friction[i] = joint.dynamics ? joint.dynamics->friction : 0.0;
    const urdf::JointLimits& limits = *joint.limits;
    const bool has_position = joint.type != urdf::Joint::CONTINUOUS;
    model_.joints.push_back({joint.name,
                             joint.child_link_name,
                             {has_position, has_position ? limits.lower : 0.0,
                              has_position ? limits.upper : 0.0, limits.velocity, limits.effort}});
    return {i, R_LB.transpose(), Vec3::Zero()};
  }

  void require_supported(const urdf::Joint& joint, const Site& parent) const {
    if (joint.type != urdf::Joint::REVOLUTE && joint.type != urdf::Joint::CONTINUOUS &&
        joint.type != urdf::Joint::PRISMATIC)
      refuse("joint '{}': floating and planar joints are not supported; make it fixed, or several joints",
             joint.name);
    if (joint.mimic)
      refuse("joint '{}': it mimics joint '{}', which armtune cannot simulate; make it fixed", joint.name,
             joint.mimic->joint_name);
    if (!joint.limits)
      refuse("joint '{}': no limits; add <limit velocity=\"..\" effort=\"..\"/> in rad/s and N m",
             joint.name);
    // Bodies are numbered along the chain: body b carries joint b + 1.
    const int next_body = parent.body + 1;
    const auto next = static_cast<std::size_t>(next_body);
    if (next < model_.joints.size())
      refuse("armtune needs a serial arm: joints '{}' and '{}' both move on '{}'; make one of them fixed",
             model_.joints[next].name, joint.name,
             next == 0 ? model_.base_link : model_.joints[next - 1].link);
    if (model_.n() == kMaxJoints)
      refuse("joint '{}': it is moving joint {}; armtune takes up to {}", joint.name, kMaxJoints + 1,
             kMaxJoints);
  }

  void add_inertia(const urdf::Link& link, const Site& site) {
    const urdf::Inertial& given = *link.inertial;
    // Merging could hide these two; the rest is judged for the whole body.
    if (given.mass < 0.0) refuse("link '{}': mass is {} kg; it must not be negative", link.name, given.mass);
    const double least = std::min({given.ixx, given.iyy, given.izz});
    if (least < 0.0)
      refuse("link '{}': a moment of inertia is {} kg m^2; none may be negative", link.name, least);
    LinkInertia about_center;
    about_center.mass = given.mass;
    about_center.inertia << given.ixx, given.ixy, given.ixz,  //
        given.ixy, given.iyy, given.iyz,                      //
        given.ixz, given.iyz, given.izz;
    const LinkInertia in_L = in_frame(about_center, rotation(given.origin), position(given.origin));
    const LinkInertia in_B = in_frame(in_L, site.R_BL, site.p_BL);
    LinkInertia& body = model_.chain.link[static_cast<std::size_t>(site.body)];
    body.mass += in_B.mass;
    body.first_moment += in_B.first_moment;
    body.inertia += in_B.inertia;
  }

  void place_tool(const UrdfOptions& options) {
    model_.tip_link = options.tip_link;
    if (model_.tip_link.empty())
      model_.tip_link = sites_.contains("tool0") ? "tool0" : model_.joints.back().link;
    const auto found = sites_.find(model_.tip_link);
    if (found == sites_.end() || found->second.body != model_.n() - 1) {
      std::string possible;
      for (const auto& [name, site] : sites_)
        if (site.body == model_.n() - 1) possible += (possible.empty() ? "" : ", ") + name;
      refuse("link '{}': the tool frame cannot be on it: {}; choose tip_link among: {}", model_.tip_link,
             found == sites_.end() ? "there is no such link" : "it is not fixed to the last moving link",
             possible);
    }
    const Site& tip = found->second;
    model_.chain.R_BT = tip.R_BL * options.R_tip_T;
    model_.chain.p_BT = tip.p_BL + tip.R_BL * options.p_tip_T;
  }

  RobotModel model_;
  std::map<std::string, Site> sites_;  ///< by link name; ordered, so that messages are
};

}  // namespace

RobotModel read_urdf(const std::string& path, const UrdfOptions& options) {
  const UrdfTree tree = parse(path);
  return ArmBuilder(path).build(*tree, options);
}

}  // namespace armtune
