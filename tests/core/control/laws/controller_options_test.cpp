// What the published law lacks, and that nothing changes without it.

#include <gtest/gtest.h>

#include <random>

#include "core/control/laws/controller.hpp"
#include "core/control/obstacle_impedance.hpp"
#include "core/control/velocity_barrier.hpp"
#include "core/robot/theta.hpp"
#include "core/trajectory/gaze_motion.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/controller_rig.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace controller_options_test {

using test::obstacles_near;
using test::WorstError;

test::Rig moving_rig() {
  test::Rig rig;
  rig.path.frequency = 0.5;
  rig.path.terms = {{1, Vec3(0.05, 0, 0), Vec3(0, 0.05, 0)}};
  return rig;
}

/// Near the goal and slow: far from saturation and from singularities.
JointState near_goal(std::mt19937& generator, const test::Rig& rig) {
  return {rig.goal().q + test::random_vector(generator, 6, 0.02), test::random_vector(generator, 6, 0.02)};
}

/// Every number of the outputs of 700 periods through all four states and a slerp, with the target's motion
/// as given.
std::vector<double> outputs(const test::Rig& rig, const Vec3& velocity, const Vec3& acceleration) {
  std::mt19937 generator(771);
  const std::unique_ptr<Controller> controller = rig.controller();
  const std::vector<Obstacle> near = obstacles_near(rig);
  std::vector<double> all;
  const auto keep = [&all](const auto& numbers) {
    for (const double number : numbers.reshaped()) all.push_back(number);
  };
  for (int step = 0; step < 700; ++step) {
    Scene scene = rig.scene();
    if (step >= 450 && step < 550) scene.obstacles = near;
    if (step >= 500) scene.target.position += Vec3(0.4, 0.3, 0.2);
    scene.target.velocity = velocity;
    scene.target.acceleration = acceleration;
    const ControlOutput& out = controller->update(near_goal(generator, rig), scene, step * rig.period);
    keep(out.torque);
    keep(out.commanded);
    keep(out.desired.acceleration);
    keep(out.desired_gaze.orientation.coeffs());
    keep(out.desired_gaze.angular_velocity);
    keep(out.desired_gaze.angular_acceleration);
    keep(out.reference.velocity);
    keep(out.reference.acceleration);
    keep(controller->theta());
    all.push_back(out.pace);
  }
  return all;
}

TEST(ControllerOptions, WithoutThemTheTargetsVelocityAndAccelerationMeanNothing) {
  const test::Rig rig = moving_rig();
  const Vec3 zero = Vec3::Zero();
  const std::vector<double> at_rest = outputs(rig, zero, zero);
  EXPECT_EQ(outputs(rig, Vec3(1.0, -2.0, 3.0), Vec3(-4.0, 5.0, 6.0)), at_rest);
  // The two options that look at them do see each.
  for (bool Gains::*option : {&Gains::gaze_feedforward, &Gains::joint_goal_follows_task}) {
    test::Rig other = rig;
    other.gains.*option = true;
    const std::vector<double> expected = outputs(other, zero, zero);
    EXPECT_NE(outputs(other, Vec3(0.1, 0.2, 0.3), zero), expected);
    EXPECT_NE(outputs(other, zero, Vec3(0.1, 0.2, 0.3)), expected);
  }
}

TEST(ControllerOptions, EachOfThemChangesSomethingAndNoneIsOnByItself) {
  const test::Rig rig = moving_rig();
  const Vec3 zero = Vec3::Zero();
  const std::vector<double> without = outputs(rig, zero, zero);
  const auto changes = [&](const char* what, const auto& turn_on) {
    test::Rig other = rig;
    turn_on(other.gains);
    EXPECT_NE(outputs(other, zero, zero), without) << what;
  };
  changes("gaze_feedforward", [](Gains& g) { g.gaze_feedforward = true; });
  changes("joint_goal_follows_task", [](Gains& g) { g.joint_goal_follows_task = true; });
  changes("velocity_margin", [](Gains& g) { g.velocity_margin = 0.1; });
  changes("velocity_barrier_gain", [](Gains& g) {
    g.velocity_barrier_gain = 1.0;
    g.velocity_barrier_start = 0.0;
  });
  changes("adaptation_filter", [](Gains& g) { g.adaptation_filter = 5.0; });
  changes("roll_centering_gain", [](Gains& g) { g.roll_centering_gain = 0.2; });
  changes("adaptation_leakage", [](Gains& g) { g.adaptation_leakage = 0.1; });
  changes("adaptation_inertia_leakage", [](Gains& g) { g.adaptation_inertia_leakage = 0.1; });
  // The model is physical and one period's step is small; a large gamma takes theta out of it.
  test::Rig rash = rig;
  rash.gains.adaptation_gain = 50.0;
  const std::vector<double> unprojected = outputs(rash, zero, zero);
  rash.gains.adaptation_projection = true;
  EXPECT_NE(outputs(rash, zero, zero), unprojected);
}

TEST(ControllerOptions, WithFeedForwardTheDesiredOrientationTurnsAsTheLineToTheTargetDoes) {
  test::Rig rig = moving_rig();
  rig.gains.gaze_feedforward = true;
  double time = 0.0;
  const std::unique_ptr<Controller> controller = rig.following(time);
  std::mt19937 generator(772);
  WorstError velocity("wd", 1e-14);  // rounding
  WorstError acceleration("wd'", 1e-14);
  const std::vector<Obstacle> near = obstacles_near(rig);
  for (int step = 0; step < 200; ++step) {
    Scene scene = rig.scene();
    scene.target.velocity = test::random_vec3(generator, 0.3);
    scene.target.acceleration = test::random_vec3(generator, 0.3);
    const bool avoiding = step >= 100;
    if (avoiding) scene.obstacles = near;
    const JointState measured = near_goal(generator, rig);
    const ControlOutput& out = controller->update(measured, scene, time += rig.period);
    ASSERT_EQ(out.state, avoiding ? ControlState::kAvoidObstacles : ControlState::kFollowTrajectory);
    ASSERT_FALSE(out.slerping);
    // Following, the tool is meant to move as the path does; avoiding, it moves as it is measured to.
    const Vec3 p_0T = test::poses_at(rig.model->chain, measured.q).p_0T;
    const Vec6 twist = test::tool_jacobian_at(rig.model->chain, measured.q) * measured.qd;
    const MotionPoint<Vec3> path = rig.path.at(time);
    const MotionPoint<Vec3> tool{p_0T, avoiding ? Vec3(twist.head<3>()) : path.velocity,
                                 avoiding ? Vec3(0.0, 0.0, 0.0) : path.acceleration};
    const TurnRate line = direction_rate(gaze_direction(tool, scene.target));
    velocity.compare(out.desired_gaze.angular_velocity, line.velocity, name(out.state));
    velocity.compare(
        out.desired_gaze.angular_velocity,
        gaze_line_rate(tool.position, tool.velocity, scene.target.position, scene.target.velocity),
        name(out.state));
    acceleration.compare(out.desired_gaze.angular_acceleration, line.acceleration, name(out.state));
    EXPECT_EQ(Vec3(out.errors.desired_rate.tail<3>()), out.desired_gaze.angular_velocity);
    EXPECT_EQ(Vec3(out.errors.desired_accel.tail<3>()), out.desired_gaze.angular_acceleration);
  }
}

/// An arm that does exactly what the reference says: a second-order step of each period, no dynamics.
void obey(const JointReference& reference, double period, JointState& state) {
  state.q += period * reference.velocity + 0.5 * period * period * reference.acceleration;
  state.qd = reference.velocity + period * reference.acceleration;
}

TEST(ControllerOptions, LeaveSingularityCanEndOnThePathInItsMotionWithTheGaze) {
  test::Rig rig = moving_rig();
  rig.path.center += Vec3(0.03, 0.06, -0.05);
  rig.p_0G += Vec3(0.1, -0.05, 0.0);
  rig.gains.joint_goal_follows_task = true;
  rig.gains.joint_trajectory_duration = 6.0;
  const Chain& chain = rig.model->chain;
  const std::unique_ptr<Controller> controller = rig.controller();
  JointState state = rig.goal();
  state.q -= (JointVector(6) << 0.5, 0.4, -0.5, 0.4, -0.5, 0.5).finished();
  double time = 0.0;
  ControlState last = ControlState::kLeaveSingularity;
  for (int step = 0; step < 3500; ++step) {
    time = step * rig.period;
    const ControlOutput& out = controller->update(state, rig.scene(), time);
    if (out.state != last && last == ControlState::kLeaveSingularity) {
      // The first period after it.
      EXPECT_NEAR(time, 6.0, 1e-9);
      const Poses poses = test::poses_at(chain, state.q);
      const MotionPoint<Vec3> path = rig.path.at(time);
      const Vec6 twist = test::tool_jacobian_at(chain, state.q) * state.qd;
      const Vec3 w_line = gaze_line_rate(poses.p_0T, path.velocity, rig.p_0G, Vec3::Zero());
      // Per step obey() is off by h^3 / 6 of some 1 rad/s^3; Kp of 1/s holds it within h^2 / 6 = 1e-6.
      EXPECT_LT((poses.p_0T - path.position).norm(), 2e-6);
      EXPECT_LT((twist.head<3>() - path.velocity).norm(), 1e-5);
      EXPECT_LT(gaze_angle(poses.R_0T, poses.p_0T, rig.p_0G), 2e-6);
      EXPECT_LT((twist.tail<3>() - w_line).norm(), 1e-5);
      EXPECT_LT((out.desired.acceleration - path.acceleration).norm(), 1e-3) << "the return starts in it";
    }
    last = out.state;
    obey(out.reference, rig.period, state);
  }
  EXPECT_EQ(last, ControlState::kFollowTrajectory);
}

TEST(ControllerOptions, LeaveSingularityGoesByWayOfItsPublishedGoal) {
  // Half-way q = (start + (goal + task) / 2) / 2: the published goal has its share.
  test::Rig rig = moving_rig();
  rig.gains.joint_goal_follows_task = true;
  rig.gains.joint_trajectory_duration = 6.0;
  rig.gains.joint_space_gains_p.setZero();
  WorstError worst("qr'", 1e-12);  // rounding
  const std::unique_ptr<Controller> controller = rig.controller();
  const JointVector start = rig.goal().q - JointVector::Constant(6, 0.4);
  TaskGoal task;
  task.start(rig.goal().q);
  for (int step = 0; step < 3000; ++step) {
    const double time = step * rig.period;
    const JointState measured{start, JointVector::Zero(6)};
    const ControlOutput& out = controller->update(measured, rig.scene(), time);
    const MotionPoint<JointVector> m = task.step(rig.model->chain, rig.path.at(time), {rig.scene().target},
                                                 inverse_damping(rig.gains), TaskMask::kPose, {}, rig.period);
    const MotionPoint<double> s = rest_to_rest(0.0, 1.0, 6.0).at(time);
    // q = start + s (goal - start + s (task - goal)).
    const JointVector expected = s.velocity * (rig.goal().q - start) +
                                 2.0 * s.position * s.velocity * (m.position - rig.goal().q) +
                                 s.position * s.position * m.velocity;
    worst.compare(out.reference.velocity, expected, "leaveSingularity", 0.1);
  }
}

TEST(ControllerOptions, TheBarrierDampsWithTheActiveKdAndFadesTheRepulsionThatPushesOn) {
  test::Rig rig = moving_rig();
  // Neither theta nor the integral, which stand still when the barrier saturates one of the two.
  rig.gains.adaptation_gain = 0.0;
  rig.gains.task_space_gains_i.setZero();
  test::Rig barred = rig;
  barred.gains.velocity_barrier_gain = 2.0;
  barred.gains.velocity_barrier_start = 0.1;
  const JointVector limits = rig.model->velocity_limits();
  const std::unique_ptr<Controller> without = rig.controller();
  const std::unique_ptr<Controller> with = barred.controller();
  const std::vector<Obstacle> near = obstacles_near(rig);
  std::mt19937 generator(774);
  WorstError worst("torque", 1e-12);  // rounding of torques of 100 N m
  int avoiding = 0;
  for (int step = 0; step < 700; ++step) {
    Scene scene = rig.scene();
    if (step >= 450) scene.obstacles = near;
    const JointState measured{rig.goal().q, test::random_vector(generator, 6, 1.0)};
    const double time = step * rig.period;
    const ControlOutput& off = without->update(measured, scene, time);
    const ControlOutput& on = with->update(measured, scene, time);
    ASSERT_EQ(on.state, off.state);
    const JointVector& Kd = off.state == ControlState::kLeaveSingularity ? rig.gains.joint_space_gains_d
                                                                         : rig.gains.task_space_gains_d;
    JointVector repulsion_torque = JointVector::Zero(6);
    if (off.state == ControlState::kAvoidObstacles) {
      ++avoiding;
      obstacle_torque(rig.model->chain, test::poses_at(rig.model->chain, measured.q), near,
                      rig.gains.obstacleInfluenceRadius, rig.gains.force_control_gains, repulsion_torque);
    }
    JointVector expected = off.commanded - repulsion_torque;
    add_behind_barrier(measured.qd, limits, 0.1, 2.0, Kd, repulsion_torque, expected);
    worst.compare(on.commanded, expected, name(on.state));
    EXPECT_NE(on.commanded, off.commanded);
  }
  EXPECT_GT(avoiding, 200);
}

}  // namespace controller_options_test
}  // namespace armtune::internal
