#include "tuner/first_task/first_gain_sets.hpp"

#include <algorithm>
#include <cmath>

#include "core/robot/dynamics.hpp"
#include "core/robot/kinematics.hpp"

namespace armtune::internal {
namespace {

constexpr double kUnknown = 0.2;    // of the weight, as of arms at random
constexpr double kGivesWay = 0.02;  // of a joint's range, under that weight
constexpr double kFirmest = 6.0;

/// Factors on starting gains.
struct Factors {
  double firmer;        ///< on Kd, and below 1 on Kp too
  double learning;      ///< on the adaptation
  double slower;        ///< on both duration gains
  double softer = 1.0;  ///< on the task's Kp alone
  bool held = false;    ///< whether the firmness that holds the arm's weight comes on top
};

/// Every set of factors that is tried, those first that are to be preferred. Durations are proportional to
/// errors, so that a small error is made good in a short time and with much acceleration: heavy arms need
/// longer ones.
std::vector<Factors> ladder() {
  std::vector<Factors> all;
  for (const double firmer : {1.0, 2.0, 0.7, 0.5, 0.35}) {
    for (const double learning : {1.0, 0.1, 0.01, 0.0}) all.push_back({firmer, learning, 1.0});
  }
  for (const double slower : {4.0, 12.0}) {
    for (const double firmer : {1.0, 2.0, 0.5}) {
      for (const double learning : {1.0, 4.0, 0.1}) all.push_back({firmer, learning, slower});
    }
  }
  // A heavy arm that was let down has an error when the task begins, which Kp turns into a jump of the
  // torque.
  for (const double slower : {4.0, 12.0}) {
    for (const double firmer : {1.0, 1.4}) {
      for (const double softer : {0.5, 0.25}) {
        for (const double learning : {1.0, 0.1}) all.push_back({firmer, learning, slower, softer, true});
      }
    }
  }
  return all;
}

/// Under firmer gains the arm gives way less to weight that the model lacks. Softer ones need less of the
/// loop: S dies with M^-1 Kd, then the error with Kp, so that both change.
Gains changed(Gains gains, const Factors& factors, const JointVector& firmness) {
  if (factors.held) {
    gains.joint_space_gains_d.array() *= firmness.array();
    gains.task_space_gains_d.array() *= firmness.array();
  }
  gains.joint_space_gains_d *= factors.firmer;
  gains.task_space_gains_d *= factors.firmer;
  if (factors.firmer < 1.0) {
    gains.joint_space_gains_p *= factors.firmer;
    gains.task_space_gains_p *= factors.firmer;
  }
  gains.task_space_gains_p *= factors.softer;
  gains.adaptation_gain *= factors.learning;
  gains.trajectoryDurationErrorGain *= factors.slower;
  gains.slerpDurationErrorGain *= factors.slower;
  return gains;
}

}  // namespace

JointVector holding_firmness(const RobotModel& robot, const JointVector& goal, const Gains& start) {
  Poses poses;
  forward_kinematics(robot.chain, goal, poses);
  JointVector gravity;
  gravity_torque(robot.chain, poses, gravity);
  JointVector firmness = JointVector::Ones(robot.n());
  for (int i = 0; i < robot.n(); ++i) {
    const JointLimits& limits = robot.joints[static_cast<std::size_t>(i)].limits;
    if (!limits.has_position) continue;
    const double gives_way =
        kUnknown * std::abs(gravity[i]) / (start.joint_space_gains_d[i] * start.joint_space_gains_p[i]);
    firmness[i] = std::clamp(gives_way / (kGivesWay * (limits.upper - limits.lower)), 1.0, kFirmest);
  }
  return firmness;
}

std::vector<Gains> first_gain_sets(const RobotModel& robot, const JointVector& goal, const Gains& start) {
  const JointVector firmness = holding_firmness(robot, goal, start);
  std::vector<Gains> sets;
  for (const Factors& factors : ladder()) sets.push_back(changed(start, factors, firmness));
  return sets;
}

}  // namespace armtune::internal
