// Implements validate() of robot_model.hpp.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "armtune/error.hpp"
#include "core/common/message_text.hpp"
#include "core/robot/body_inertia.hpp"
#include "core/robot/robot_model.hpp"

namespace armtune::internal {
namespace {

constexpr double kRotationTolerance = 1e-6;
constexpr double kHeaviest = 1e6;  ///< kg: above any arm's link; rounding does not lose the inertia yet
constexpr double kFarthest = 1e4;  ///< m: longer than any arm; its square keeps enough digits

/// The fields of the error if a check fails. They are turned into text only then.
struct Checked {
  std::string_view owner = {};       ///< name of the link or joint; empty: the whole arm
  std::string_view what = {};        ///< the property of the owner, as in theta_names or a robot YAML
  std::optional<double> value = {};  ///< nothing: no single number is wrong
  std::string_view limit = {};
};

/// Checks a model. At the first fault it throws an InputError such as "FILE: link 'x': value; limit", with a
/// key such as `x/mass`.
class Checker {
 public:
  explicit Checker(const RobotModel& model) : model_(model) {}

  void arm() const;
  void link(int i) const;
  void joint(int i) const;

 private:
  template <typename... Args>
  void require(bool holds, const Checked& checked, fmt::format_string<Args...> text, Args&&... args) const {
    if (holds) return;
    const auto& [owner, what, value, limit] = checked;
    throw error(owner.empty() ? std::string(what) : fmt::format("{}/{}", owner, what),
                fmt::format(text, std::forward<Args>(args)...))
        .with_value(value ? fmt::format("{:.6g}", *value) : std::string(), std::string(limit));
  }
  InputError error(std::string key, const std::string& problem) const {
    const std::string& where = model_.source.empty() ? model_.name : model_.source;
    return {InputPlace{where, 0, std::move(key)}, problem};
  }
  void name(const char* kind, const std::string& name) const;
  void characters(const char* kind, const std::string& name) const;
  void pose(const char* kind, const std::string& owner, const Mat3& R, const Vec3& p) const;
  void position_limits(int i) const;
  void moments(int i) const;

  const RobotModel& model_;
};

void Checker::name(const char* kind, const std::string& name) const {
  if (name.empty())
    throw error(kind, fmt::format("a {} has an empty name; give it one", kind)).with_value({}, "a name");
  characters(kind, name);
}

void Checker::characters(const char* kind, const std::string& name) const {
  constexpr std::size_t kLongest = 255;
  if (name.size() > kLongest) {
    throw error(kind, fmt::format("{} {}: its name has {} bytes; rename it to at most {} bytes", kind,
                                  shown(name), name.size(), kLongest))
        .with_value(std::to_string(name.size()), fmt::format("at most {} bytes", kLongest));
  }
  const bool printable = std::none_of(name.begin(), name.end(), [](char c) {
    return c == ',' || c == '"' || static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
  });
  const auto refuse = [&](const std::string& why, const char* limit) {
    throw error(kind, fmt::format("{} {}: {}", kind, shown(name), why)).with_value(name, limit);
  };
  if (!printable)
    refuse(
        "its name contains a comma, a quote or a control character; rename it, because CSV files contain it",
        "a name without commas, quotes and control characters");
  if (is_formula(name))
    refuse(
        "its name begins like a spreadsheet formula; rename it, because the name is written into CSV files",
        "a name that is not a formula");
  if (!is_utf8(name)) refuse("its name is not UTF-8; save the file as UTF-8, or rename it", "UTF-8");
}

void Checker::pose(const char* kind, const std::string& owner, const Mat3& R, const Vec3& p) const {
  require(p.allFinite() && R.allFinite(), {owner, "origin", {}, "finite"}, "{} '{}': its pose is not finite",
          kind, owner);
  const double distance = p.stableNorm();
  require(distance <= kFarthest, {owner, "origin", distance, "at most 10000 m"},
          "{} '{}': its origin is {:.6g} m from that of its parent; it must be at most {:.0f} m", kind, owner,
          distance, kFarthest);
  const bool proper =
      (R * R.transpose() - Mat3::Identity()).norm() < kRotationTolerance && R.determinant() > 0.0;
  require(proper, {owner, "origin", {}, "a rotation matrix"},
          "{} '{}': its orientation is not a rotation matrix (determinant {:.6g}, must be 1)", kind, owner,
          R.determinant());
}

void Checker::arm() const {
  const Chain& chain = model_.chain;
  name("robot", model_.name);
  characters("link", model_.base_link);
  characters("link", model_.tip_link);
  require(chain.n > 0, {{}, "joints", chain.n, "at least 1"},
          "robot '{}' has no revolute, continuous or prismatic joint; there is nothing to control",
          model_.name);
  require(chain.n <= kMaxJoints, {{}, "joints", chain.n, "at most 12"},
          "robot '{}' has {} moving joints; armtune supports at most {}", model_.name, chain.n, kMaxJoints);
  static_assert(kMaxJoints == 12, "the message above names this number");
  const bool consistent = static_cast<int>(model_.joints.size()) == chain.n &&
                          chain.rotor_inertia.size() == chain.n && chain.viscous_friction.size() == chain.n &&
                          chain.coulomb_friction.size() == chain.n;
  require(consistent, {{}, "joints", {}, "one entry for each joint"},
          "robot '{}': names, rotor inertia and friction must have one entry for each of its {} joints",
          model_.name, chain.n);
  require(chain.link_radius.size() == 0 || chain.link_radius.size() == chain.n,
          {{}, "link_radius", static_cast<double>(chain.link_radius.size()), "one for each link, or none"},
          "robot '{}' has {} link radii for {} links; give one for each, or none", model_.name,
          chain.link_radius.size(), chain.n);
  require(chain.gravity.allFinite(), {{}, "gravity", {}, "finite"}, "robot '{}': gravity is not finite",
          model_.name);
  pose("tool frame on link", model_.tip_link, chain.R_BT, chain.p_BT);
}

void Checker::link(int i) const {
  const auto k = static_cast<std::size_t>(i);
  const LinkInertia& body = model_.chain.link[k];
  const std::string& link = model_.joints[k].link;
  name("link", link);
  require(std::isfinite(body.mass) && body.mass > 0.0, {link, "mass", body.mass, "finite and above 0"},
          "link '{}': mass is {:.6g} kg; the link moves, so its mass must be finite and > 0", link,
          body.mass);
  require(body.mass <= kHeaviest, {link, "mass", body.mass, "at most 1000000 kg"},
          "link '{}': mass is {:.6g} kg, but a link may have at most {:.0f} kg; give it in kg", link,
          body.mass, kHeaviest);
  require(body.first_moment.allFinite() && body.inertia.allFinite(), {link, "inertia", {}, "finite"},
          "link '{}': centre of mass or inertia is not finite", link);
  const double far = (body.first_moment / body.mass).stableNorm();
  require(far <= kFarthest, {link, "center", far, "at most 10000 m"},
          "link '{}': its centre of mass is {:.6g} m from its joint; it must be at most {:.0f} m", link, far,
          kFarthest);
  moments(i);
}

void Checker::moments(int i) const {
  const auto k = static_cast<std::size_t>(i);
  const std::string& link = model_.joints[k].link;
  const LinkInertia& body = model_.chain.link[k];
  const Mat3& I_B = body.inertia;
  const double largest = I_B.cwiseAbs().maxCoeff();
  require(largest <= kHeaviest * kFarthest * kFarthest, {link, "inertia", largest, "at most 1e+14 kg m^2"},
          "link '{}': its inertia is {:.6g} kg m^2, but a link may have at most {:.0e}; give it in kg m^2",
          link, largest, kHeaviest * kFarthest * kFarthest);
  require((I_B - I_B.transpose()).norm() <= kRotationTolerance * I_B.norm(),
          {link, "inertia", {}, "symmetric"}, "link '{}': inertia is not symmetric (ixy {:.6g}, iyx {:.6g})",
          link, I_B(0, 1), I_B(1, 0));
  const Vec3 principal = principal_moments(body);
  if (!is_physical(body)) {
    throw error(link + "/inertia",
                fmt::format("link '{}': its principal moments of inertia about its centre of mass are "
                            "{:.6g}, {:.6g} and {:.6g} kg m^2; no rigid body has a negative one, or one "
                            "larger than the sum of the other two (triangle inequality)",
                            link, principal[0], principal[1], principal[2]))
        .with_value(fmt::format("{:.6g}, {:.6g}, {:.6g}", principal[0], principal[1], principal[2]),
                    "moments of a rigid body");
  }
  if (model_.chain.motion[k] == JointMotion::kRevolute)
    require(has_inertia_about_axis(body), {link, "inertia", I_B(2, 2), "above 0 about the axis of the joint"},
            "link '{}': inertia about the axis of joint '{}' is {:.6g} kg m^2; the link turns about it, so "
            "it must be > 0",
            link, model_.joints[k].name, I_B(2, 2));
}

void Checker::position_limits(int i) const {
  const auto k = static_cast<std::size_t>(i);
  const std::string& joint = model_.joints[k].name;
  const JointLimits& limits = model_.joints[k].limits;
  const bool revolute = model_.chain.motion[k] == JointMotion::kRevolute;
  const char* unit = revolute ? "rad" : "m";
  if (limits.has_position) {
    const bool lower = std::isfinite(limits.lower);
    require(lower && std::isfinite(limits.upper),
            {joint, lower ? "upper" : "lower", lower ? limits.upper : limits.lower, "finite"},
            "joint '{}': position limits {} and {} {} must be finite", joint, limits.lower, limits.upper,
            unit);
    if (!(limits.lower < limits.upper)) {
      throw error(joint + "/lower",
                  fmt::format("joint '{}': lower limit {} {} is not below its upper limit {}", joint,
                              limits.lower, unit, limits.upper))
          .with_value(fmt::format("{:.6g}", limits.lower), fmt::format("below {:.6g}", limits.upper));
    }
  }
  require(limits.has_position || revolute, {joint, "lower", {}, "position limits"},
          "joint '{}': a prismatic joint needs position limits", joint);
  const double farthest = std::abs(limits.lower) > std::abs(limits.upper) ? limits.lower : limits.upper;
  require(revolute || std::abs(farthest) <= kFarthest,
          {joint, farthest == limits.upper ? "upper" : "lower", farthest, "at most 10000 m"},
          "joint '{}': position limits {} and {} m are beyond {:.0f} m; give the joint's travel in m", joint,
          limits.lower, limits.upper, kFarthest);
}

void Checker::joint(int i) const {
  const auto k = static_cast<std::size_t>(i);
  const Chain& chain = model_.chain;
  const std::string& joint = model_.joints[k].name;
  const JointLimits& limits = model_.joints[k].limits;
  const bool revolute = chain.motion[k] == JointMotion::kRevolute;
  const char* unit = revolute ? "rad" : "m";
  name("joint", joint);
  pose("joint", joint, chain.R_PB0[k], chain.p_PB0[k]);
  position_limits(i);
  require(std::isfinite(limits.velocity) && limits.velocity > 0.0,
          {joint, "velocity", limits.velocity, "finite and above 0"},
          "joint '{}': velocity limit is {} {}/s; it must be finite and > 0: give it in the URDF, or by "
          "'limits' in a robot YAML",
          joint, limits.velocity, unit);
  require(std::isfinite(limits.effort) && limits.effort > 0.0,
          {joint, "effort", limits.effort, "finite and above 0"},
          "joint '{}': effort limit is {} {}; it must be finite and > 0: give it in the URDF, or by 'limits' "
          "in a robot YAML",
          joint, limits.effort, revolute ? "N m" : "N");
  require(limits.acceleration > 0.0, {joint, "acceleration", limits.acceleration, "above 0"},
          "joint '{}': acceleration limit is {} {}/s^2; it must be > 0: correct 'limits' in the robot YAML",
          joint, limits.acceleration, unit);
  const auto not_negative = [&](const char* what, std::string_view key, double value) {
    require(std::isfinite(value) && value >= 0.0, {joint, key, value, "finite and 0 or more"},
            "joint '{}': {} is {}; it must be finite and 0 or more", joint, what, value);
  };
  not_negative("rotor inertia", "rotor_inertia", chain.rotor_inertia[i]);
  not_negative("viscous friction", "viscous_friction", chain.viscous_friction[i]);
  not_negative("Coulomb friction", "coulomb_friction", chain.coulomb_friction[i]);
}

}  // namespace

void validate(const RobotModel& model) {
  const Checker check(model);
  check.arm();
  for (int i = 0; i < model.n(); ++i) {
    check.joint(i);
    check.link(i);
  }
}

}  // namespace armtune::internal
