#include "core/control/laws/starting_gains.hpp"

#include <algorithm>
#include <cmath>

#include "core/control/laws/first_gains.hpp"

namespace armtune::internal {
namespace {

constexpr double kJointRate = 5.0;           // 1/s
constexpr double kShareOfVelocity = 0.4;     // largest share of velocity limits on the way to the goal
constexpr double kShortest = 3.0;            // s, least duration of that motion
constexpr double kQuinticPeak = 15.0 / 8.0;  // peak over mean velocity of a rest-to-rest quintic

}  // namespace

Gains starting_gains(const RobotModel& robot, const JointVector& start, const JointVector& goal,
                     double manipulability) {
  const int n = robot.n();
  const double size = reach(robot);

  Gains gains;
  gains.joint_space_goal = in_degrees(robot, goal);
  gains.joint_space_gains_p = JointVector::Constant(n, kJointRate);
  gains.joint_space_gains_d = kFirstRate * joint_inertia(robot, goal);
  first_references(gains);
  gains.task_space_gains_d = gains.joint_space_gains_d;
  const double slowest = ((goal - start).array().abs() / robot.velocity_limits().array()).maxCoeff();
  gains.joint_trajectory_duration = std::max(kShortest, std::ceil(kQuinticPeak * slowest / kShareOfVelocity));
  // These lengths have the ratio to the reach that the published gains have to the UR10's reach.
  gains.obstacleInfluenceRadius = 0.25 * size;
  gains.trajectoryDurationErrorGain = 9.0 / size;
  gains.force_control_gains = JointVector::Constant(n, 2.0 * robot.effort_limits().maxCoeff() / size);
  gains.manipulability_threshold = 0.3 * manipulability;
  gains.manipulability_damping = 0.03 * size * size;
  gains.joint_centering_gain = 0.2;
  gains.variable_damping = true;
  gains.gaze_feedforward = true;
  gains.slerp_start_angle = 0.03;
  gains.joint_goal_follows_task = true;
  gains.velocity_margin = 0.72;
  gains.velocity_barrier_start = 0.6;
  gains.velocity_barrier_gain = 1.0;
  gains.adapt_while_avoiding = false;
  gains.adaptation_projection = true;
  gains.adaptation_filter = 5.0;
  gains.adaptation_leakage = 0.01;
  gains.roll_centering_gain = 0.1;
  return gains;
}

}  // namespace armtune::internal
