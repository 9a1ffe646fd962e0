#include "sim/scenario/plausibility.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/robot/body_inertia.hpp"
#include "core/robot/rotor_estimate.hpp"
#include "sim/scenario/holding_torques.hpp"

namespace armtune::internal {
namespace {

constexpr double kLightest =
    5e-4;  // kg for each N m or N of the joint's effort limit: arms have at least seven times as much
/// Weight of all moving links, at full reach, as a share of the smallest effort limit. It is at least 1 for
/// all bundled arms, and for 13 URDFs that vendors publish.
constexpr double kLightestArm = 0.2;
constexpr double kWidest = 0.5;         // largest radius of gyration of a link, as a share of the reach
constexpr double kNarrowest = 2e-3;     // m, smallest radius of gyration of a link
constexpr double kManyTurns = 25.0;     // rad
constexpr double kFastest = 30.0;       // rad/s
constexpr double kFingerStroke = 0.15;  // m
constexpr double kClawTurn = 1.3;       // rad; a wrist's range is more than half a turn
constexpr double kOtherRotor = 100.0;   // largest factor from the estimate of rotor_estimate.hpp, up or down
constexpr int kFewestIdentical = 4;     // links; fewer can be the same by design

using Names = std::vector<std::string>;
using Proposed = std::vector<ProposedValue>;

/// Adds the sentence "NAMES: SAYS" to the doubts, unless there are no names.
void add(const Names& names, const std::string& says, const Proposed& proposed, std::vector<Doubt>& doubts) {
  if (!names.empty()) doubts.push_back({fmt::format("{}: {}", fmt::join(names, ", "), says), proposed});
}

/// Adds mass and inertia of a link, without values, which only the arm's maker can give.
void ask_for_body(const std::string& link, Proposed& proposed) {
  for (const char* field : {"mass", "center", "moments"}) proposed.push_back({"inertia", link, field, ""});
}

/// Returns the text of an angle in radians that was given in degrees.
std::string in_radians(double degrees) {
  return fmt::format("{:.4g}", degrees * M_PI / 180.0);
}

/// Returns the largest radius of gyration about an axis through the centre of mass [m].
double radius_of_gyration(const LinkInertia& link) {
  const Vec3 center = link.first_moment / link.mass;
  const LinkInertia about_center = in_frame(link, Mat3::Identity(), -center);
  const double largest = Eigen::SelfAdjointEigenSolver<Mat3>(about_center.inertia).eigenvalues().maxCoeff();
  return std::sqrt(std::max(0.0, largest) / link.mass);
}

bool contains(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Returns true if the inertia of joint i's link is a placeholder.
bool lacks_inertia(const RobotModel& robot, int i, const MissingData& missing) {
  return contains(missing.inertia, robot.joints[static_cast<std::size_t>(i)].link) ||
         std::any_of(missing.impossible.begin(), missing.impossible.end(),
                     [i](const ImpossibleInertia& link) { return link.joint == i && !link.is_complete(); });
}

bool lacks_any_inertia(const RobotModel& robot, const MissingData& missing) {
  for (int i = 0; i < robot.n(); ++i) {
    if (lacks_inertia(robot, i, missing)) return true;
  }
  return false;
}

/// Returns the weight of all moving links [N].
double weight(const RobotModel& robot) {
  constexpr double kGravity = 9.81;
  double mass = 0.0;
  for (int i = 0; i < robot.n(); ++i) mass += robot.chain.link[static_cast<std::size_t>(i)].mass;
  return kGravity * mass;
}

/// Finds arms that are so light that each of their joints could hold the whole arm several times over, with
/// all of its mass at full reach. Joints without an effort limit do not count. Returns true if the arm is
/// one.
bool doubt_light_arm(const RobotModel& robot, const MissingData& missing, std::vector<Doubt>& doubts) {
  if (lacks_any_inertia(robot, missing)) return false;
  const JointInfo* weakest = nullptr;
  double largest = 0.0;
  for (int i = 0; i < robot.n(); ++i) {
    const JointInfo& joint = robot.joints[static_cast<std::size_t>(i)];
    if (contains(missing.effort, joint.name)) continue;
    const bool slides = robot.chain.motion[static_cast<std::size_t>(i)] == JointMotion::kPrismatic;
    const double share = weight(robot) * (slides ? 1.0 : reach(robot)) / joint.limits.effort;
    if (share <= largest) continue;
    largest = share;
    weakest = &joint;
  }
  if (weakest == nullptr || largest >= kLightestArm) return false;
  Names names;
  Proposed proposed;
  for (int i = 0; i < robot.n(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    names.push_back(fmt::format("{} ({:.3g} kg)", robot.joints[k].link, robot.chain.link[k].mass));
    ask_for_body(robot.joints[k].link, proposed);
  }
  add(names,
      fmt::format(
          "these links are very light: if all their mass were at the arm's reach of {:.3g} m, every joint, "
          "even '{}', could hold it with {:.2g} % of its effort limit; if the masses are "
          "placeholders, give the real ones, and otherwise check the effort limits",
          reach(robot), weakest->name, 100.0 * largest),
      proposed, doubts);
  return true;
}

void doubt_links(const RobotModel& robot, const MissingData& missing, std::vector<Doubt>& doubts) {
  const bool all_light = doubt_light_arm(robot, missing, doubts);
  Names light, wide, narrow;
  Proposed of_light, of_wide, of_narrow;
  const double widest = kWidest * reach(robot);
  for (int i = 0; i < robot.n(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const LinkInertia& link = robot.chain.link[k];
    const JointInfo& joint = robot.joints[k];
    if (lacks_inertia(robot, i, missing)) continue;
    const double radius = radius_of_gyration(link);
    if (!all_light && link.mass < kLightest * joint.limits.effort && !contains(missing.effort, joint.name)) {
      light.push_back(fmt::format("{} ({:.3g} kg)", joint.link, link.mass));
      ask_for_body(joint.link, of_light);
    }
    if (radius > widest) {
      wide.push_back(fmt::format("{} ({:.3g} m)", joint.link, radius));
      ask_for_body(joint.link, of_wide);
    }
    if (radius < kNarrowest) {
      narrow.push_back(fmt::format("{} ({:.3g} m)", joint.link, radius));
      ask_for_body(joint.link, of_narrow);
    }
  }
  add(light,
      "these links are very light for the effort limits of their joints; if the masses are placeholders, "
      "give the real ones",
      of_light, doubts);
  add(wide,
      fmt::format(
          "the radius of gyration of these links is more than half of the arm's reach of {:.3g} m; give "
          "inertia in kg m^2, about the centre of mass",
          reach(robot)),
      of_wide, doubts);
  add(narrow, "the radius of gyration of these links is less than 2 mm; give inertia in kg m^2", of_narrow,
      doubts);
}

/// True if mass and principal moments about the centre of mass are the same, but for the rounding of the
/// transformation from the frames of the URDF.
bool are_identical(const LinkInertia& a, const LinkInertia& b) {
  constexpr double kRounding = 1e-9;
  const Vec3 moments = principal_moments(a);
  return a.mass == b.mass && (moments - principal_moments(b)).norm() <= kRounding * moments.norm();
}

/// Finds links that all have the same inertia, as files have that were exported without masses.
void doubt_identical_links(const RobotModel& robot, const MissingData& missing, std::vector<Doubt>& doubts) {
  if (robot.n() < kFewestIdentical || lacks_any_inertia(robot, missing)) return;
  const LinkInertia& first = robot.chain.link[0];
  Names names;
  Proposed proposed;
  for (int i = 0; i < robot.n(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!are_identical(first, robot.chain.link[k])) return;
    names.push_back(robot.joints[k].link);
    ask_for_body(robot.joints[k].link, proposed);
  }
  add(names,
      fmt::format("all moving links have the same mass of {:.3g} kg and the same inertia, which are probably "
                  "placeholders; give the real ones",
                  first.mass),
      proposed, doubts);
}

/// Finds rotor inertia that does not fit the joint's limits, often because the gear ratio was left out.
/// Estimates of the user's own count too: the limits show which of them are far off. A velocity limit that
/// looks like degrees per second suggests no rotor inertia.
void doubt_rotors(const RobotModel& robot, const MissingData& missing, std::vector<Doubt>& doubts) {
  RobotModel ruled = robot;
  ruled.chain.rotor_inertia.setZero();
  estimate_rotors(ruled);
  Names names, estimates;
  for (int i = 0; i < robot.n(); ++i) {
    const JointInfo& joint = robot.joints[static_cast<std::size_t>(i)];
    const double rotor = robot.chain.rotor_inertia[i];
    estimates.push_back(fmt::format("{:.6g}", rotor));
    if (contains(missing.velocity, joint.name) || contains(missing.effort, joint.name)) continue;
    if (joint.limits.velocity >= kFastest) continue;
    const double rule = ruled.chain.rotor_inertia[i];
    if (rotor == 0.0) estimates.back() = fmt::format("{:.2g}", rule);
    if (rotor == 0.0 || (rotor >= rule / kOtherRotor && rotor <= rule * kOtherRotor)) continue;
    names.push_back(fmt::format("{} ({:.2g}, expected {:.2g})", joint.name, rotor, rule));
    estimates.back() = fmt::format("{:.2g}", rule);
  }
  constexpr const char* kSays =
      "the rotor inertia differs by more than a factor of {:.0f} from the value expected for these effort and "
      "velocity limits; give the motor's inertia times the square of the gear ratio, or the expected value";
  // 'rotor_inertia: estimated' would not replace what the URDF gives.
  const std::string list = fmt::format("[{}]", fmt::join(estimates, ", "));
  add(names, fmt::format(kSays, kOtherRotor), {{"rotor_inertia", "estimated", "", list}}, doubts);
}

void doubt_limits(const RobotModel& robot, std::vector<Doubt>& doubts) {
  Names positions, velocities;
  Proposed of_positions, of_velocities;
  for (int i = 0; i < robot.n(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (robot.chain.motion[k] == JointMotion::kPrismatic) continue;
    const JointInfo& joint = robot.joints[k];
    const double farthest = std::max(std::abs(joint.limits.lower), std::abs(joint.limits.upper));
    if (joint.limits.has_position && farthest >= kManyTurns && farthest <= 720.0) {
      positions.push_back(fmt::format("{} ({:.4g})", joint.name, farthest));
      of_positions.push_back({"limits", joint.name, "lower", in_radians(joint.limits.lower)});
      of_positions.push_back({"limits", joint.name, "upper", in_radians(joint.limits.upper)});
    }
    if (joint.limits.velocity >= kFastest) {
      velocities.push_back(fmt::format("{} ({:.4g})", joint.name, joint.limits.velocity));
      of_velocities.push_back({"limits", joint.name, "velocity", in_radians(joint.limits.velocity)});
    }
  }
  add(positions, "these position limits look like degrees; a URDF has radians", of_positions, doubts);
  add(velocities, "these velocity limits look like degrees per second; a URDF has rad/s", of_velocities,
      doubts);
}

/// Finds joints whose effort limit is too low to hold the arm still everywhere.
void doubt_efforts(const RobotModel& robot, const MissingData& missing, std::vector<Doubt>& doubts) {
  if (!missing.position.empty() || lacks_any_inertia(robot, missing)) return;
  for (const JointHold& heaviest : heaviest_holds(robot)) {
    const JointInfo& joint = robot.joints[static_cast<std::size_t>(heaviest.joint)];
    if (heaviest.torque <= joint.limits.effort || contains(missing.effort, joint.name)) continue;
    doubts.push_back({fmt::format("{}: it needs {}; check the limit and the masses", joint.name,
                                  compared_with_limit(robot, heaviest)),
                      {{"limits", joint.name, "effort", ""}}});
  }
}

void doubt_last_joint(const RobotModel& robot, std::vector<Doubt>& doubts) {
  const auto last = static_cast<std::size_t>(robot.n() - 1);
  const JointInfo& joint = robot.joints[last];
  if (robot.n() < 4 || !joint.limits.has_position) return;
  const bool slides = robot.chain.motion[last] == JointMotion::kPrismatic;
  const double stroke = joint.limits.upper - joint.limits.lower;
  if (stroke > (slides ? kFingerStroke : kClawTurn)) return;
  const std::string rest =
      fmt::format("{:.3g}", std::max(joint.limits.lower, std::min(joint.limits.upper, 0.0)));
  doubts.push_back(
      {fmt::format(
           "{}: the last joint {} by only {:.3g} {}, like a gripper's finger; if it is one, fix it with "
           "'hold: {{{}: {}}}' in a robot YAML",
           joint.name, slides ? "slides" : "turns", stroke, slides ? "m" : "rad", joint.name, rest),
       {{"hold", joint.name, "", rest}}});
}

}  // namespace

std::vector<Doubt> doubts_with_proposals(const RobotModel& robot, const MissingData& missing) {
  std::vector<Doubt> found;
  doubt_links(robot, missing, found);
  doubt_identical_links(robot, missing, found);
  doubt_rotors(robot, missing, found);
  doubt_limits(robot, found);
  doubt_efforts(robot, missing, found);
  doubt_last_joint(robot, found);
  return found;
}

std::vector<std::string> doubts(const RobotModel& robot) {
  std::vector<std::string> sentences;
  for (const Doubt& doubt : doubts_with_proposals(robot)) sentences.push_back(doubt.says);
  return sentences;
}

}  // namespace armtune::internal
