#include "sim/scenario/holding_torques.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "armtune/error.hpp"
#include "core/control/pose_search.hpp"
#include "core/robot/dynamics.hpp"
#include "core/robot/holding_load.hpp"

namespace armtune::internal {
namespace {

constexpr double kFewestHeld = 0.05;  // share of joint positions
constexpr unsigned kPoses = 500;      // from which the largest torques are searched
constexpr unsigned kSurveyed = 2000;  // as many as a quick search for a task rates

JointVector holding_torque(const RobotModel& robot, const JointVector& q) {
  Poses poses;
  forward_kinematics(robot.chain, q, poses);
  JointVector torque;
  gravity_torque(robot.chain, poses, torque);
  return torque;
}

/// Moves one joint after the other, in ever smaller steps, to increase the holding torque.
void climb(const RobotModel& robot, JointHold& heaviest) {
  double step = 1.0;
  for (int halving = 0; halving < 6; ++halving) {
    step *= 0.5;
    for (int k = 0; k < robot.n(); ++k) {
      for (const double sign : {-1.0, 1.0}) {
        JointVector q = heaviest.q;
        q[k] += sign * step;
        const JointLimits& limits = robot.joints[static_cast<std::size_t>(k)].limits;
        if (limits.has_position) q[k] = std::clamp(q[k], limits.lower, limits.upper);
        const double torque = std::abs(holding_torque(robot, q)[heaviest.joint]);
        if (torque > heaviest.torque) heaviest = {heaviest.joint, torque, q};
      }
    }
  }
}

struct HoldingSurvey {
  double held =
      0.0;  ///< share of positions at which no joint needs more than `most_load` of its effort limit
  JointHold typical;  ///< the joint with the largest load, at the position with the median of these loads
};

/// Surveys a fixed series of joint positions.
HoldingSurvey survey_holding(const RobotModel& robot, double most_load) {
  struct Loaded {
    HoldingLoad load;
    unsigned sample;
  };
  const JointVector efforts = robot.effort_limits();
  std::vector<Loaded> all;
  all.reserve(kSurveyed);
  unsigned held = 0;
  for (unsigned sample = 0; sample < kSurveyed; ++sample) {
    all.push_back({holding_load(robot.chain, sample_position(robot, sample), efforts), sample});
    if (all.back().load.share <= most_load) ++held;
  }
  const auto middle = all.begin() + kSurveyed / 2;
  std::nth_element(all.begin(), middle, all.end(),
                   [](const Loaded& a, const Loaded& b) { return a.load.share < b.load.share; });
  const int joint = middle->load.joint;
  return {static_cast<double>(held) / kSurveyed,
          {joint, middle->load.share * efforts[joint], sample_position(robot, middle->sample)}};
}

}  // namespace

std::vector<JointHold> heaviest_holds(const RobotModel& robot) {
  std::vector<JointHold> found(static_cast<std::size_t>(robot.n()));
  for (unsigned sample = 0; sample < kPoses; ++sample) {
    const JointVector q = sample_position(robot, sample);
    const JointVector torque = holding_torque(robot, q);
    for (int i = 0; i < robot.n(); ++i) {
      JointHold& heaviest = found[static_cast<std::size_t>(i)];
      if (std::abs(torque[i]) >= heaviest.torque) heaviest = {i, std::abs(torque[i]), q};
    }
  }
  for (JointHold& heaviest : found) climb(robot, heaviest);
  return found;
}

void refuse_too_heavy(const RobotModel& robot, double most_load) {
  const HoldingSurvey survey = survey_holding(robot, most_load);
  if (survey.held >= kFewestHeld) return;
  const JointInfo& joint = robot.joints[static_cast<std::size_t>(survey.typical.joint)];
  throw InputError(
      InputPlace{robot.source, 0, joint.name + "/effort"},
      fmt::format(
          "no first task is possible for {}: in {:.0f} % of the arm's poses, some joint needs more than "
          "{:.0f} % of its effort limit only to hold the arm still. For example, joint '{}' needs {}. "
          "Check the effort limits and the masses, or write a scenario with your own path",
          robot.name, 100.0 * (1.0 - survey.held), 100.0 * most_load, joint.name,
          compared_with_limit(robot, survey.typical)))
      .with_value(fmt::format("{:g}", joint.limits.effort),
                  fmt::format("above {:.3g}", survey.typical.torque));
}

const char* effort_unit(const RobotModel& robot, int joint) {
  return robot.chain.motion[static_cast<std::size_t>(joint)] == JointMotion::kPrismatic ? "N" : "N m";
}

std::string compared_with_limit(const RobotModel& robot, const JointHold& hold) {
  bool any_slides = false;
  for (int i = 0; i < robot.n(); ++i)
    any_slides = any_slides || robot.chain.motion[static_cast<std::size_t>(i)] == JointMotion::kPrismatic;
  const char* unit = effort_unit(robot, hold.joint);
  return fmt::format("{:.3g} {} to hold the arm still at [{:.3g}] deg{}, and its effort limit is {:.3g} {}",
                     hold.torque, unit, fmt::join(in_degrees(robot, hold.q), ", "),
                     any_slides ? " and m" : "",
                     robot.joints[static_cast<std::size_t>(hold.joint)].limits.effort, unit);
}

}  // namespace armtune::internal
