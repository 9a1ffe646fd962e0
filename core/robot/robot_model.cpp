#include "core/robot/robot_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "armtune/error.hpp"

namespace armtune::internal {
namespace {

/// Returns the inertia of a unit point mass at p about the origin: |p|^2 1 - p p^T (Steiner's theorem).
Mat3 unit_point_inertia(const Vec3& p) {
  return p.squaredNorm() * Mat3::Identity() - p * p.transpose();
}

}  // namespace

int RobotModel::joint_index(const std::string& joint) const {
  std::string known;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (joints[i].name == joint) return static_cast<int>(i);
    known += (i == 0 ? "" : ", ") + joints[i].name;
  }
  throw InputError(InputPlace{source.empty() ? name : source, 0, "joint"},
                   fmt::format("no joint '{}'; its joints are: {}", joint, known))
      .with_value(joint, "one of: " + known);
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
    throw InputError(InputPlace{.key = "payload/mass"},
                     InputFault{.problem = fmt::format("{} is not the mass of a payload", payload.mass),
                                .value = fmt::to_string(payload.mass),
                                .limit = "a finite number of kg, 0 or more"});
  if (!payload.center.allFinite())
    throw InputError(InputPlace{.key = "payload/center"},
                     InputFault{.problem = "the centre is not finite",
                                .limit = "three finite numbers in metres, in the tool frame"});
  RobotModel loaded = model;
  LinkInertia& last = loaded.chain.link[static_cast<std::size_t>(model.n() - 1)];
  const Vec3 p_BC = model.chain.p_BT + model.chain.R_BT * payload.center;
  last.mass += payload.mass;
  last.first_moment += payload.mass * p_BC;
  last.inertia += payload.mass * unit_point_inertia(p_BC);
  return loaded;
}

}  // namespace armtune::internal
