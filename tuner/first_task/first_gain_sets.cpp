#include "tuner/first_task/first_gain_sets.hpp"

#include <algorithm>
#include <cmath>

#include "core/robot/dynamics.hpp"
#include "core/robot/kinematics.hpp"

namespace armtune::internal {
namespace {

constexpr double kUnknown = 0.2;    // share of the weight that the model lacks, as for random arms
constexpr double kGivesWay = 0.02;  // share of a joint's range by which it may give way under that weight
constexpr double kFirmest = 6.0;

/// Factors by which the starting gains are multiplied.
struct Factors {
  double firmer;        ///< factor of Kd; below 1, it applies to Kp too
  double learning;      ///< factor of the adaptation gain
  double slower;        ///< factor of both duration gains
  double softer = 1.0;  ///< further factor of the task-space Kp
  bool held = false;    ///< true: Kd is also multiplied by holding_firmness
};

/// Returns all sets of factors that are tried, preferred sets first. Motion durations are proportional to
/// errors. A small error is therefore corrected in a short time and with high acceleration, so heavy arms
/// need larger duration gains.
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
  // A heavy arm that has sagged has an error when the task begins. Kp turns this error into a jump of the
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

/// Returns the gains multiplied by the factors. With higher gains, the arm gives way less under weight that
/// the model lacks. Lower gains demand less of the loop: S decays at the rate M^-1 Kd, and then the error at
/// the rate Kp, so both are lowered.
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
