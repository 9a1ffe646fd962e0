#include "core/robot/robot_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "armtune/error.hpp"
#include "core/common/message_text.hpp"
#include "core/robot/body_inertia.hpp"

namespace armtune::internal {
namespace {

/// Returns the inertia of a unit point mass at p about the origin: |p|^2 1 - p p^T (Steiner's theorem).
Mat3 unit_point_inertia(const Vec3& p) {
  return p.squaredNorm() * Mat3::Identity() - p * p.transpose();
}

constexpr double kRotationTolerance = 1e-6;
constexpr double kHeaviest = 1e6;  ///< kg: above any arm's link; rounding does not lose the inertia yet
constexpr double kFarthest = 1e4;  ///< m: longer than any arm; its square keeps enough digits

/// Checks a model. At the first fault it throws an InputError such as "FILE: link 'x': value; limit".
class Checker {
 public:
  explicit Checker(const RobotModel& model) : model_(model) {}

  void arm() const;
  void link(int i) const;
  void joint(int i) const;

 private:
  template <typename... Args>
  void require(bool holds, fmt::format_string<Args...> text, Args&&... args) const {
    if (holds) return;
    const std::string& where = model_.source.empty() ? model_.name : model_.source;
    throw InputError(InputPlace{where}, fmt::format(text, std::forward<Args>(args)...));
  }
  void name(const char* kind, const std::string& name) const;
  void characters(const char* kind, const std::string& name) const;
  void rotation(const char* what, const std::string& owner, const Mat3& R, const Vec3& p) const;

  const RobotModel& model_;
};

void Checker::name(const char* kind, const std::string& name) const {
  require(!name.empty(), "a {} has an empty name; give it one", kind);
  characters(kind, name);
}

void Checker::characters(const char* kind, const std::string& name) const {
  constexpr std::size_t kLongest = 255;
  const bool printable = std::none_of(name.begin(), name.end(), [](char c) {
    return c == ',' || c == '"' || static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
  });
  require(name.size() <= kLongest, "{} {}: its name has {} bytes; rename it to at most {} bytes", kind,
          shown(name), name.size(), kLongest);
  require(printable,
          "{} '{}': its name contains a comma, a quote or a control character; rename it, because CSV files "
          "contain it",
          kind, name);
  require(
      !is_formula(name),
      "{} {}: its name begins like a spreadsheet formula; rename it, because the name is written into CSV files",
      kind, shown(name));
  require(is_utf8(name), "{} {}: its name is not UTF-8; save the file as UTF-8, or rename it", kind,
          shown(name));
}

void Checker::rotation(const char* what, const std::string& owner, const Mat3& R, const Vec3& p) const {
  require(p.allFinite() && R.allFinite(), "{} '{}': its pose is not finite", what, owner);
  require(p.stableNorm() <= kFarthest,
          "{} '{}': its origin is {:.6g} m from that of its parent; it must be at most {:.0f} m", what, owner,
          p.stableNorm(), kFarthest);
  const bool proper =
      (R * R.transpose() - Mat3::Identity()).norm() < kRotationTolerance && R.determinant() > 0.0;
  require(proper, "{} '{}': its orientation is not a rotation matrix (determinant {:.6g}, must be 1)", what,
          owner, R.determinant());
}

void Checker::arm() const {
  const Chain& chain = model_.chain;
  name("robot", model_.name);
  characters("link", model_.base_link);
  characters("link", model_.tip_link);
  require(chain.n > 0,
          "robot '{}' has no revolute, continuous or prismatic joint; there is nothing to control",
          model_.name);
  require(chain.n <= kMaxJoints, "robot '{}' has {} moving joints; armtune supports at most {}", model_.name,
          chain.n, kMaxJoints);
  const bool consistent = static_cast<int>(model_.joints.size()) == chain.n &&
                          chain.rotor_inertia.size() == chain.n && chain.viscous_friction.size() == chain.n &&
                          chain.coulomb_friction.size() == chain.n;
  require(consistent,
          "robot '{}': names, rotor inertia and friction must have one entry for each of its {} joints",
          model_.name, chain.n);
  require(chain.link_radius.size() == 0 || chain.link_radius.size() == chain.n,
          "robot '{}' has {} link radii for {} links; give one for each, or none", model_.name,
          chain.link_radius.size(), chain.n);
  require(chain.gravity.allFinite(), "robot '{}': gravity is not finite", model_.name);
  rotation("tool frame on link", model_.tip_link, chain.R_BT, chain.p_BT);
}

void Checker::link(int i) const {
  const auto k = static_cast<std::size_t>(i);
  const LinkInertia& body = model_.chain.link[k];
  const std::string& link = model_.joints[k].link;
  name("link", link);
  require(std::isfinite(body.mass) && body.mass > 0.0,
          "link '{}': mass is {:.6g} kg; the link moves, so its mass must be finite and > 0", link,
          body.mass);
  require(body.mass <= kHeaviest,
          "link '{}': mass is {:.6g} kg, but a link may have at most {:.0f} kg; give it in kg", link,
          body.mass, kHeaviest);
  require(body.first_moment.allFinite() && body.inertia.allFinite(),
          "link '{}': centre of mass or inertia is not finite", link);
  const double far = (body.first_moment / body.mass).stableNorm();
  require(far <= kFarthest,
          "link '{}': its centre of mass is {:.6g} m from its joint; it must be at most {:.0f} m", link, far,
          kFarthest);
  const Mat3& I_B = body.inertia;
  const double largest = I_B.cwiseAbs().maxCoeff();
  require(largest <= kHeaviest * kFarthest * kFarthest,
          "link '{}': its inertia is {:.6g} kg m^2, but a link may have at most {:.0e}; give it in kg m^2",
          link, largest, kHeaviest * kFarthest * kFarthest);
  require((I_B - I_B.transpose()).norm() <= kRotationTolerance * I_B.norm(),
          "link '{}': inertia is not symmetric (ixy {:.6g}, iyx {:.6g})", link, I_B(0, 1), I_B(1, 0));

  const Vec3 moments = principal_moments(body);
  require(is_physical(body),
          "link '{}': its principal moments of inertia about its centre of mass are {:.6g}, {:.6g} and "
          "{:.6g} kg m^2; no rigid body has a negative one, or one larger than the sum of the other two "
          "(triangle inequality)",
          link, moments[0], moments[1], moments[2]);
  if (model_.chain.motion[k] == JointMotion::kRevolute)
    require(has_inertia_about_axis(body),
            "link '{}': inertia about the axis of joint '{}' is {:.6g} kg m^2; the link turns about it, so "
            "it must be > 0",
            link, model_.joints[k].name, I_B(2, 2));
}

void Checker::joint(int i) const {
  const auto k = static_cast<std::size_t>(i);
  const Chain& chain = model_.chain;
  const std::string& joint = model_.joints[k].name;
  const JointLimits& limits = model_.joints[k].limits;
  const bool revolute = chain.motion[k] == JointMotion::kRevolute;
  const char* unit = revolute ? "rad" : "m";
  name("joint", joint);
  rotation("joint", joint, chain.R_PB0[k], chain.p_PB0[k]);
  if (limits.has_position) {
    require(std::isfinite(limits.lower) && std::isfinite(limits.upper),
            "joint '{}': position limits {} and {} {} must be finite", joint, limits.lower, limits.upper,
            unit);
    require(limits.lower < limits.upper, "joint '{}': lower limit {} {} is not below its upper limit {}",
            joint, limits.lower, unit, limits.upper);
  }
  require(limits.has_position || revolute, "joint '{}': a prismatic joint needs position limits", joint);
  require(revolute || std::max(std::abs(limits.lower), std::abs(limits.upper)) <= kFarthest,
          "joint '{}': position limits {} and {} m are beyond {:.0f} m; give the joint's travel in m", joint,
          limits.lower, limits.upper, kFarthest);
  require(std::isfinite(limits.velocity) && limits.velocity > 0.0,
          "joint '{}': velocity limit is {} {}/s; it must be finite and > 0: give it in the URDF, or by "
          "'limits' in a robot YAML",
          joint, limits.velocity, unit);
  require(std::isfinite(limits.effort) && limits.effort > 0.0,
          "joint '{}': effort limit is {} {}; it must be finite and > 0: give it in the URDF, or by 'limits' "
          "in a robot YAML",
          joint, limits.effort, revolute ? "N m" : "N");
  require(limits.acceleration > 0.0,
          "joint '{}': acceleration limit is {} {}/s^2; it must be > 0: correct 'limits' in the robot YAML",
          joint, limits.acceleration, unit);
  const auto not_negative = [&](const char* what, double value) {
    require(std::isfinite(value) && value >= 0.0, "joint '{}': {} is {}; it must be finite and 0 or more",
            joint, what, value);
  };
  not_negative("rotor inertia", chain.rotor_inertia[i]);
  not_negative("viscous friction", chain.viscous_friction[i]);
  not_negative("Coulomb friction", chain.coulomb_friction[i]);
}

}  // namespace

int RobotModel::joint_index(const std::string& joint) const {
  std::string known;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (joints[i].name == joint) return static_cast<int>(i);
    known += (i == 0 ? "" : ", ") + joints[i].name;
  }
  throw InputError(
      fmt::format("{}: no joint '{}'; its joints are: {}", source.empty() ? name : source, joint, known));
}

JointVector RobotModel::velocity_limits() const {
  JointVector limits(n());
  for (int i = 0; i < n(); ++i) limits[i] = joints[static_cast<std::size_t>(i)].limits.velocity;
  return limits;
}

JointVector RobotModel::effort_limits() const {
  JointVector limits(n());
  for (int i = 0; i < n(); ++i) limits[i] = joints[static_cast<std::size_t>(i)].limits.effort;
  return limits;
}

JointVector RobotModel::acceleration_limits() const {
  JointVector limits(n());
  for (int i = 0; i < n(); ++i) limits[i] = joints[static_cast<std::size_t>(i)].limits.acceleration;
  return limits;
}

JointVector RobotModel::lower_limits() const {
  JointVector limits(n());
  for (int i = 0; i < n(); ++i) {
    const JointLimits& of_joint = joints[static_cast<std::size_t>(i)].limits;
    limits[i] = of_joint.has_position ? of_joint.lower : -std::numeric_limits<double>::infinity();
  }
  return limits;
}

JointVector RobotModel::upper_limits() const {
  JointVector limits(n());
  for (int i = 0; i < n(); ++i) {
    const JointLimits& of_joint = joints[static_cast<std::size_t>(i)].limits;
    limits[i] = of_joint.has_position ? of_joint.upper : std::numeric_limits<double>::infinity();
  }
  return limits;
}

std::vector<std::string> joint_names(const RobotModel& model) {
  std::vector<std::string> names;
  for (const JointInfo& joint : model.joints) names.push_back(joint.name);
  return names;
}

std::vector<std::string> theta_names(const RobotModel& model) {
  constexpr std::array<const char*, kLinkParameters> kLink = {"mass", "mx",  "my",  "mz",  "ixx",
                                                              "ixy",  "ixz", "iyy", "iyz", "izz"};
  constexpr std::array<const char*, kJointParameters> kJoint = {"rotor_inertia", "viscous_friction",
                                                                "coulomb_friction"};
  std::vector<std::string> names;
  names.reserve(model.joints.size() * (kLink.size() + kJoint.size()));
  for (const JointInfo& joint : model.joints)
    for (const char* parameter : kLink) names.push_back(joint.link + "/" + parameter);
  for (const JointInfo& joint : model.joints)
    for (const char* parameter : kJoint) names.push_back(joint.name + "/" + parameter);
  return names;
}

JointVector in_degrees(const RobotModel& model, const JointVector& q) {
  JointVector degrees = q;
  for (int i = 0; i < model.n(); ++i) {
    if (model.chain.motion[static_cast<std::size_t>(i)] == JointMotion::kRevolute) degrees[i] *= 180.0 / M_PI;
  }
  return degrees;
}

JointVector in_si(const RobotModel& model, const JointVector& degrees) {
  JointVector q = degrees;
  for (int i = 0; i < model.n(); ++i) {
    if (model.chain.motion[static_cast<std::size_t>(i)] == JointMotion::kRevolute) q[i] *= M_PI / 180.0;
  }
  return q;
}

double reach(const RobotModel& model) {
  const Chain& chain = model.chain;
  double sum = chain.p_BT.norm();
  for (int i = 0; i < chain.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (i > 0) sum += chain.p_PB0[k].norm();
    if (chain.motion[k] == JointMotion::kPrismatic) {
      const JointLimits& limits = model.joints[k].limits;
      sum += std::max(std::abs(limits.lower), std::abs(limits.upper));
    }
  }
  return sum;
}

LinkInertia in_frame(const LinkInertia& body_B, const Mat3& R_AB, const Vec3& p_AB) {
  const Vec3 h_A = R_AB * body_B.first_moment;
  LinkInertia body_A;
  body_A.mass = body_B.mass;
  body_A.first_moment = h_A + body_B.mass * p_AB;
  // Integral of |r + p|^2 1 - (r + p)(r + p)^T over the mass, multiplied out.
  body_A.inertia = R_AB * body_B.inertia * R_AB.transpose() + 2.0 * p_AB.dot(h_A) * Mat3::Identity() -
                   h_A * p_AB.transpose() - p_AB * h_A.transpose() + body_B.mass * unit_point_inertia(p_AB);
  return body_A;
}

RobotModel with_payload(const RobotModel& model, const Payload& payload) {
  if (!std::isfinite(payload.mass) || payload.mass < 0.0)
    throw InputError(fmt::format("payload: mass is {} kg; it must be finite and 0 or more", payload.mass));
  if (!payload.center.allFinite())
    throw InputError("payload: its centre is not finite; give three numbers in metres, in the tool frame");
  RobotModel loaded = model;
  LinkInertia& last = loaded.chain.link[static_cast<std::size_t>(model.n() - 1)];
  const Vec3 p_BC = model.chain.p_BT + model.chain.R_BT * payload.center;
  last.mass += payload.mass;
  last.first_moment += payload.mass * p_BC;
  last.inertia += payload.mass * unit_point_inertia(p_BC);
  return loaded;
}

void validate(const RobotModel& model) {
  const Checker check(model);
  check.arm();
  for (int i = 0; i < model.n(); ++i) {
    check.joint(i);
    check.link(i);
  }
}

}  // namespace armtune::internal
