#include "core/robot/urdf_arm.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "armtune/error.hpp"
#include "core/robot/link_inertias.hpp"
#include "core/robot/urdf_limits.hpp"
#include "core/robot/urdf_selection.hpp"

namespace armtune::internal {
namespace {

/// Returns the smallest rotation that takes z onto the unit vector `axis`. For -z it is a half turn about x.
Mat3 z_onto(const Vec3& axis) {
  const double sine_squared = axis.x() * axis.x() + axis.y() * axis.y();
  if (axis.z() < 0.0 && sine_squared < 1e-24) return Vec3(1.0, -1.0, -1.0).asDiagonal();
  // 1 + cos(angle), in a form without cancellation near -z.
  const double w = axis.z() < 0.0 ? sine_squared / (1.0 - axis.z()) : 1.0 + axis.z();
  return Eigen::Quaterniond(w, -axis.y(), axis.x(), 0.0).normalized().toRotationMatrix();
}

class ArmBuilder {
 public:
  ArmBuilder(const std::string& source, const UrdfOptions& options, MissingData* missing)
      : options_(options), missing_(missing) {
    model_.source = source;
    model_.files = {source};
  }

  RobotModel build(const UrdfTree& tree) {
    tree_ = &tree;
    model_.name = tree.name;
    require_tree(tree, model_.source);
    selection_ = select_arm(tree, options_, model_.source);
    model_.base_link = selection_.base;
    model_.chain.gravity = base_in_root(tree).transpose() * model_.chain.gravity;
    place_links(tree);
    if (!loose_.empty()) refuse_loose();
    refuse_unused();
    if (model_.n() > 0) place_tool();
    for (const auto& [name, site] : sites_) model_.links.push_back({name, site.body, site.R_BL, site.p_BL});
    link_inertias_.judge(model_.chain, model_.source, missing_);
    if (missing_ != nullptr) find_massless();
    validate(model_);
    return std::move(model_);
  }

 private:
  /// key: the name of a joint, or a key of a robot YAML such as `limits/elbow`. value and limit: those of the
  /// InputError.
  [[noreturn]] void refuse(const std::string& key, const std::string& value, const std::string& limit,
                           const std::string& problem) const {
    throw InputError(InputPlace{model_.source, 0, key}, problem).with_value(value, limit);
  }

  /// Returns the orientation of the base link's frame in the root link's frame.
  Mat3 base_in_root(const UrdfTree& tree) const {
    std::map<std::string, const UrdfJoint*> to;  // by link: the joint that leads to it
    for (const auto& [name, joint] : tree.joints) to.emplace(joint.child, &joint);
    Mat3 R = Mat3::Identity();
    for (auto way = to.find(selection_.base); way != to.end(); way = to.find(way->second->parent)) {
      const UrdfJoint& joint = *way->second;
      const Site at_zero{-1, joint.R_PL, joint.p_PL};
      R = (is_held(joint) ? held_site(joint, at_zero) : at_zero).R_BL * R;
    }
    return R;
  }

  /// Visits every link of the arm once, from its base outwards.
  void place_links(const UrdfTree& tree) {
    std::vector<std::string> open{selection_.base};
    sites_.emplace(selection_.base, Site{});
    while (!open.empty()) {
      const UrdfLink& link = tree.links.at(open.back());
      open.pop_back();
      const Site site = sites_.at(link.name);
      if (site.body >= 0) add_inertia(link, site);
      add_shapes(link.name, shapes_of(link), site);
      for (const std::string& name : link.joints) {
        const UrdfJoint& joint = tree.joints.at(name);
        if (site.body < 0 && is_beside(joint)) continue;  // branches off the fixed base: not part of the arm
        sites_.emplace(joint.child, site_behind(joint, site));
        open.push_back(joint.child);
      }
    }
  }

  /// Returns the link's visual and collision shapes. Shapes in the options replace its collision shapes.
  std::vector<Shape> shapes_of(const UrdfLink& link) const {
    const auto given = options_.shapes.find(link.name);
    if (given == options_.shapes.end()) return link.shapes;
    std::vector<Shape> shapes = link.shapes;
    std::erase_if(shapes, [](const Shape& shape) { return shape.collision; });
    shapes.insert(shapes.end(), given->second.begin(), given->second.end());
    return shapes;
  }

  void add_shapes(const std::string& link, const std::vector<Shape>& shapes, const Site& site) {
    const int number = model_.shapes.empty() ? 0 : model_.shapes.back().link + 1;
    for (Shape shape : shapes) {
      shape.body = site.body;
      shape.link = number;
      shape.link_name = link;
      shape.p_BS = site.p_BL + site.R_BL * shape.p_BS;
      shape.R_BS = site.R_BL * shape.R_BS;
      if (shape.R_BS.allFinite() && shape.p_BS.allFinite()) model_.shapes.push_back(shape);
    }
  }

  bool is_held(const UrdfJoint& joint) const { return options_.held.contains(joint.name); }
  /// Returns true if the joint moves but is not part of the chain from the base to the tip link.
  bool is_beside(const UrdfJoint& joint) const {
    return joint.motion != UrdfMotion::kFixed && !is_held(joint) && selection_.has_tip &&
           !selection_.on_the_way.contains(joint.name);
  }

  [[noreturn]] void refuse_loose() const {
    std::string names, held;
    for (const UrdfJoint* joint : loose_) {
      names += (names.empty() ? "'" : ", '") + joint->name + "'";
      held += fmt::format("{}{}: {}", held.empty() ? "" : ", ", joint->name, place_to_hold(*joint, options_));
    }
    const std::string hold = fmt::format("hold: {{{}}}", held);
    refuse(loose_.front()->name, {}, hold,
           fmt::format("the moving joints {} are not part of the chain to '{}'; fix them at a position (rad "
                       "or m) with '{}' in a robot YAML",
                       names, tip_name(), hold));
  }

  /// Refuses limits, shapes and inertias in the options that belong to no part of the arm.
  void refuse_unused() const {
    for (const auto& [name, limits] : options_.limits) {
      if (!options_.held.contains(name)) {
        if (moves(name)) continue;
        refuse("limits/" + name, name, "a moving joint of the arm",
               fmt::format("limits: joint '{}' is not a moving joint of this arm; leave it out", name));
      } else if (limits.velocity || limits.effort || limits.acceleration) {
        refuse("limits/" + name, {}, "lower and upper only",
               fmt::format("limits: joint '{}' is fixed by 'hold', so only lower and upper are used; leave "
                           "out velocity, effort and acceleration",
                           name));
      }
    }
    for (const auto& [name, shapes] : options_.shapes) {
      if (sites_.contains(name)) continue;
      refuse("shapes/" + name, name, "a link of the arm",
             fmt::format("shapes: link '{}' is not part of this arm; leave it out", name));
    }
    for (const auto& [name, inertia] : options_.inertia) {
      const auto site = sites_.find(name);
      if (site == sites_.end() || site->second.body < 0)
        refuse("inertia/" + name, name, "a link that the arm moves",
               fmt::format("inertia: link '{}' is not moved by this arm; leave it out", name));
    }
  }

  bool moves(const std::string& joint) const {
    return std::any_of(model_.joints.begin(), model_.joints.end(),
                       [&](const JointInfo& info) { return info.name == joint; });
  }

  /// Returns the site of the joint's child link. A moving joint starts a new body.
  Site site_behind(const UrdfJoint& joint, const Site& parent) {
    const Mat3 R_PL = parent.R_BL * joint.R_PL;
    const Vec3 p_PL = parent.p_BL + parent.R_BL * joint.p_PL;
    if (joint.motion == UrdfMotion::kFixed) return {parent.body, R_PL, p_PL};
    if (is_held(joint)) return held_site(joint, {parent.body, R_PL, p_PL});
    if (is_beside(joint) && joint.motion != UrdfMotion::kOther) {  // kOther cannot be held
      loose_.push_back(&joint);
      return {parent.body, R_PL, p_PL};
    }
    require_supported(joint, parent);
    return moving_site(joint, R_PL, p_PL);
  }

  Vec3 axis_of(const UrdfJoint& joint) const {
    const Vec3& axis = joint.axis;
    const double length = axis.norm();
    if (!std::isfinite(length) || length < 1e-9)
      refuse(joint.name + "/axis", fmt::format("{} {} {}", axis.x(), axis.y(), axis.z()), "a unit vector",
             fmt::format("joint '{}': axis '{} {} {}' has no direction; give it a unit vector", joint.name,
                         axis.x(), axis.y(), axis.z()));
    return axis / length;
  }

  /// Returns the site of the joint's child link as if the joint were fixed at the position where it is held.
  Site held_site(const UrdfJoint& joint, const Site& at_zero) const {
    const Vec3 axis = axis_of(joint);
    const double q = options_.held.at(joint.name);
    Site site = at_zero;
    if (joint.motion == UrdfMotion::kPrismatic) {
      site.p_BL += at_zero.R_BL * (q * axis);
    } else {
      site.R_BL = at_zero.R_BL * Eigen::AngleAxisd(q, axis).toRotationMatrix();
    }
    return site;
  }

  Site moving_site(const UrdfJoint& joint, const Mat3& R_PL, const Vec3& p_PL) {
    const Vec3 axis = axis_of(joint);
    Chain& chain = model_.chain;
    const int i = chain.n++;
    const auto k = static_cast<std::size_t>(i);
    const Mat3 R_LB = z_onto(axis);
    const bool prismatic = joint.motion == UrdfMotion::kPrismatic;
    chain.motion[k] = prismatic ? JointMotion::kPrismatic : JointMotion::kRevolute;
    chain.R_PB0[k] = R_PL * R_LB;
    chain.p_PB0[k] = p_PL;
    chain.rotor_inertia.conservativeResize(chain.n);
    chain.viscous_friction.conservativeResize(chain.n);
    chain.coulomb_friction.conservativeResize(chain.n);
    chain.rotor_inertia[i] = joint.rotor_inertia;
    chain.viscous_friction[i] = joint.damping;
    chain.coulomb_friction[i] = joint.friction;
    model_.joints.push_back(
        {joint.name, joint.child, limits_of(joint, options_, model_.source, missing_), joint.interfaces});
    return {i, R_LB.transpose(), Vec3::Zero()};
  }

  void find_massless() {
    for (int i = 0; i < model_.n(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      LinkInertia& body = model_.chain.link[k];
      if (body.mass > 0.0) continue;
      missing_->inertia.push_back(model_.joints[k].link);
      body = {1.0, Vec3::Zero(), Mat3::Identity()};
    }
  }

  /// Refuses a joint that mimics another one, its leader. The message names all joints to hold: those with
  /// this leader, and the leader itself if it moves on the same link as one of them, like the fingers of a
  /// gripper. If only one finger were held, the other would become a joint of the arm.
  [[noreturn]] void refuse_mimic(const UrdfJoint& joint) const {
    const auto leader = tree_->joints.find(joint.mimics);
    std::string held;
    const auto add = [&](const UrdfJoint& one) {
      held += fmt::format("{}{}: {}", held.empty() ? "" : ", ", one.name, place_to_hold(one, options_));
    };
    const auto follows = [&](const auto& entry) {
      return entry.second.mimics == joint.mimics && !is_held(entry.second);
    };
    const bool fingers = leader != tree_->joints.end() &&
                         std::any_of(tree_->joints.begin(), tree_->joints.end(), [&](const auto& entry) {
                           return entry.second.mimics == joint.mimics && entry.first != leader->first &&
                                  entry.second.parent == leader->second.parent;
                         });
    if (fingers && !is_held(leader->second)) add(leader->second);
    for (const auto& entry : tree_->joints) {
      if (follows(entry)) add(entry.second);
    }
    const std::string hold = fmt::format("hold: {{{}}}", held);
    refuse(joint.name, joint.mimics, hold,
           fmt::format("joint '{}': it mimics joint '{}'{}, which armtune cannot simulate; use '{}' in a "
                       "robot YAML",
                       joint.name, joint.mimics, fingers ? ", as the fingers of a gripper do" : "", hold));
  }

  void require_supported(const UrdfJoint& joint, const Site& parent) const {
    if (joint.motion == UrdfMotion::kOther)
      refuse(joint.name, {}, "a fixed, revolute, continuous or prismatic joint",
             fmt::format("joint '{}': floating and planar joints are not supported; replace it by a fixed "
                         "joint, or by revolute and prismatic joints",
                         joint.name));
    if (!joint.mimics.empty()) refuse_mimic(joint);
    if (!joint.limits && missing_ == nullptr && !options_.limits.contains(joint.name))
      refuse(joint.name + "/limit", {}, "<limit velocity=\"..\" effort=\"..\"/>",
             fmt::format("joint '{}': no limits; add <limit velocity=\"..\" effort=\"..\"/> in rad/s and N m",
                         joint.name));
    // Bodies are numbered along the chain: body b carries joint b + 1.
    const int next_body = parent.body + 1;
    const auto next = static_cast<std::size_t>(next_body);
    if (next < model_.joints.size()) refuse_branch(joint, next);
    if (model_.n() == kMaxJoints)
      refuse(joint.name, std::to_string(kMaxJoints + 1), fmt::format("at most {} moving joints", kMaxJoints),
             fmt::format("joint '{}' is moving joint number {}; armtune supports at most {}", joint.name,
                         kMaxJoints + 1, kMaxJoints));
  }

  /// Refuses a joint that moves on the same link as the arm's joint `next`.
  [[noreturn]] void refuse_branch(const UrdfJoint& joint, std::size_t next) const {
    const UrdfJoint& other = tree_->joints.at(model_.joints[next].name);
    const std::string hold =
        fmt::format("hold: {{{}: {}, {}: {}}}", other.name, place_to_hold(other, options_), joint.name,
                    place_to_hold(joint, options_));
    refuse(
        joint.name, other.name, "one moving joint on each link",
        fmt::format(
            "armtune needs a serial arm, but the moving joints '{}' and '{}' are both attached to link "
            "'{}'. If they are the fingers of a gripper, hold both with '{}' in a robot YAML; otherwise name "
            "the tip_link, or hold the joint that is not part of the arm",
            other.name, joint.name, next == 0 ? model_.base_link : model_.joints[next - 1].link, hold));
  }

  void add_inertia(const UrdfLink& link, const Site& site) {
    if (const auto told = options_.inertia.find(link.name); told != options_.inertia.end()) {
      link_inertias_.add(link.name, told->second, site, model_.chain);
    } else if (link.inertial) {
      link_inertias_.add(link, site, model_.chain);
    }
  }

  std::string tip_name() const {
    if (!options_.tip_link.empty()) return options_.tip_link;
    return sites_.contains("tool0") ? "tool0" : model_.joints.back().link;
  }

  void place_tool() {
    model_.tip_link = tip_name();
    const auto found = sites_.find(model_.tip_link);
    if (found == sites_.end() || found->second.body != model_.n() - 1) {
      std::string possible;
      for (const auto& [name, site] : sites_)
        if (site.body == model_.n() - 1) possible += (possible.empty() ? "" : ", ") + name;
      refuse("tip_link", model_.tip_link, "one of: " + possible,
             fmt::format(
                 "link '{}' cannot carry the tool frame: {}; set tip_link to one of: {}", model_.tip_link,
                 found == sites_.end() ? "there is no such link" : "it is not fixed to the last moving link",
                 possible));
    }
    const Site& tip = found->second;
    model_.chain.R_BT = tip.R_BL * options_.R_tip_T;
    model_.chain.p_BT = tip.p_BL + tip.R_BL * options_.p_tip_T;
    mount_tool();
  }

  /// Adds the tool's inertia and shapes to the last body.
  void mount_tool() {
    const Site at_tool{model_.n() - 1, model_.chain.R_BT, model_.chain.p_BT};
    if (options_.tool_inertia) add_to_body(in_link_frame(*options_.tool_inertia), at_tool, model_.chain);
    add_shapes("tool", options_.tool_shapes, at_tool);
  }

  const UrdfOptions& options_;
  MissingData* missing_;
  const UrdfTree* tree_ = nullptr;
  UrdfSelection selection_;
  RobotModel model_;
  std::vector<const UrdfJoint*> loose_;  ///< joints that move on the arm but do not belong to it
  LinkInertias link_inertias_;
  std::map<std::string, Site> sites_;  ///< by link name; sorted, as are the names in messages
};

}  // namespace

RobotModel build_arm(const UrdfTree& tree, const UrdfOptions& options, const std::string& source,
                     MissingData* missing) {
  return ArmBuilder(source, options, missing).build(tree);
}

}  // namespace armtune::internal
