#include "sim/scenario/plausibility.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/control/pose_search.hpp"
#include "core/robot/holding_load.hpp"
#include "sim/yaml/quoted.hpp"

namespace armtune::internal {
namespace {

constexpr double kLightest =
    5e-4;  // kg for each N m or N of the joint's effort: arms have seven times that and more
constexpr double kWidest = 0.5;         // of the reach: radius of gyration of a link
constexpr double kNarrowest = 2e-3;     // m
constexpr double kManyTurns = 25.0;     // rad
constexpr double kFastest = 30.0;       // rad/s
constexpr double kFingerStroke = 0.15;  // m
constexpr unsigned kPoses = 500;

using Names = std::vector<std::string>;
using Proposed = std::vector<ProposedValue>;

/// Adds the sentence unless there are no names. It begins with them.
void add(const Names& names, const std::string& says, const Proposed& proposed, std::vector<Doubt>& doubts) {
  if (!names.empty()) doubts.push_back({fmt::format("{}: {}", fmt::join(names, ", "), says), proposed});
}

/// Mass and inertia of a link, which nobody but the arm's maker knows.
void ask_for_body(const std::string& link, Proposed& proposed) {
  for (const char* field : {"mass", "center", "moments"}) proposed.push_back({"inertia", link, field, ""});
}

/// A value that was given in degrees.
std::string in_radians(double degrees) {
  return fmt::format("{:.4g}", degrees * M_PI / 180.0);
}

/// Radius of gyration about the centre of mass and its worst axis [m].
double radius_of_gyration(const LinkInertia& link) {
  const Vec3 center = link.first_moment / link.mass;
  const LinkInertia about_center = in_frame(link, Mat3::Identity(), -center);
  const double largest = Eigen::SelfAdjointEigenSolver<Mat3>(about_center.inertia).eigenvalues().maxCoeff();
  return std::sqrt(std::max(0.0, largest) / link.mass);
}

void doubt_links(const RobotModel& robot, std::vector<Doubt>& doubts) {
  Names light, wide, narrow;
  Proposed of_light, of_wide, of_narrow;
  const double widest = kWidest * reach(robot);
  for (int i = 0; i < robot.n(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const LinkInertia& link = robot.chain.link[k];
    const JointInfo& joint = robot.joints[k];
    const double radius = radius_of_gyration(link);
    if (link.mass < kLightest * joint.limits.effort) {
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
      "these links are very light for the effort of their joints; if the masses are placeholders, give the arm's own",
      of_light, doubts);
  add(wide,
      fmt::format(
          "the radius of gyration of these links is more than half of the arm's reach of {:.3g} m; give inertia in kg m^2, about the centre of mass",
          reach(robot)),
      of_wide, doubts);
  add(narrow, "the radius of gyration of these links is less than 2 mm; give inertia in kg m^2", of_narrow,
      doubts);
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

/// The pose, of many at random, in which gravity takes the largest share of an effort limit.
void doubt_efforts(const RobotModel& robot, std::vector<Doubt>& doubts) {
  const JointVector efforts = robot.effort_limits();
  const bool slides = std::any_of(robot.chain.motion.begin(), robot.chain.motion.begin() + robot.n(),
                                  [](JointMotion motion) { return motion == JointMotion::kPrismatic; });
  double largest = 1.0;
  Doubt found;
  for (unsigned sample = 0; sample < kPoses; ++sample) {
    const JointVector q = sample_position(robot, sample);
    const HoldingLoad load = holding_load(robot.chain, q, efforts);
    if (load.share <= largest) continue;
    largest = load.share;
    const JointVector shown = in_degrees(robot, q);
    const std::string& name = robot.joints[static_cast<std::size_t>(load.joint)].name;
    found.proposed = {{"limits", name, "effort", ""}};
    found.says = fmt::format(
        "{}: it needs {:.3g} to hold the arm still at [{:.3g}] deg{}, and its effort limit is {:.3g}; check the limit "
        "and the masses",
        name, load.share * efforts[load.joint], fmt::join(shown, ", "), slides ? " and m" : "",
        efforts[load.joint]);
  }
  if (!found.says.empty()) doubts.push_back(found);
}

void doubt_last_joint(const RobotModel& robot, std::vector<Doubt>& doubts) {
  const auto last = static_cast<std::size_t>(robot.n() - 1);
  const JointInfo& joint = robot.joints[last];
  if (robot.chain.motion[last] != JointMotion::kPrismatic || robot.n() < 4) return;
  const double stroke = joint.limits.upper - joint.limits.lower;
  if (stroke > kFingerStroke) return;
  const std::string rest =
      fmt::format("{:.3g}", std::max(joint.limits.lower, std::min(joint.limits.upper, 0.0)));
  doubts.push_back(
      {fmt::format(
           "{}: the last joint slides by {:.3g} m only, as a gripper's finger does; if it is one, hold it by 'hold: {{{}: {}}}' in a "
           "robot YAML",
           joint.name, stroke, joint.name, rest),
       {{"hold", joint.name, "", rest}}});
}

/// The proposed values as lines of a robot YAML, each a comment.
std::string proposed_lines(const Proposed& proposed) {
  std::string text, key, name;
  for (const ProposedValue& p : proposed) {
    if (p.key != key) text += fmt::format("# {}:\n", p.key);
    if (p.field.empty()) {
      text += fmt::format("#   {}: {}\n", yaml::quoted(p.name), p.value);
    } else {
      if (p.key != key || p.name != name) text += fmt::format("#   {}:\n", yaml::quoted(p.name));
      text += fmt::format("#     {}: {}\n", p.field, p.value);
    }
    key = p.key;
    name = p.name;
  }
  return text;
}

}  // namespace

std::vector<Doubt> doubts_with_proposals(const RobotModel& robot) {
  std::vector<Doubt> found;
  doubt_links(robot, found);
  doubt_limits(robot, found);
  doubt_efforts(robot, found);
  doubt_last_joint(robot, found);
  return found;
}

std::vector<std::string> doubts(const RobotModel& robot) {
  std::vector<std::string> sentences;
  for (const Doubt& doubt : doubts_with_proposals(robot)) sentences.push_back(doubt.says);
  return sentences;
}

std::string proposals_yaml(const std::string& urdf, const std::vector<Doubt>& found) {
  std::string text = urdf.empty() ? "" : fmt::format("urdf: {}\n", yaml::quoted(urdf));
  text +=
      "# What armtune doubts, and what could stand here instead. Take the # away from what is right, give the\n"
      "# values that are missing, and put lines under one key together.\n";
  for (const Doubt& doubt : found)
    text += fmt::format("\n{}{}", yaml::comment(doubt.says), proposed_lines(doubt.proposed));
  return text;
}

}  // namespace armtune::internal
