// The control law, driven directly with measured states: no simulator, no feedback.
#include "core/control/laws/controller.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/control/obstacle_impedance.hpp"
#include "core/robot/theta.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/controller_rig.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace controller_test {

using test::WorstError;

/// Near the goal and slow: far from saturation and from singularities.
JointState near_goal(std::mt19937& generator, const test::Rig& rig) {
  return {rig.goal().q + test::random_vector(generator, 6, 0.02), test::random_vector(generator, 6, 0.02)};
}

/// One period as a test sees it.
struct Period {
  JointState measured;
  Scene scene;
  double time;
  ParameterVector theta_before;
  const ControlOutput* out;
  const Controller* controller;
};

/// Measured states near the goal through all four states; a target elsewhere starts slerps.
template <typename Check>
void drive(const test::Rig& rig, const Check& check) {
  std::mt19937 generator(611);
  const std::unique_ptr<Controller> controller = rig.controller();
  const Poses poses = test::poses_at(rig.model->chain, rig.goal().q);
  const std::vector<Obstacle> near = {{poses.p_0B[2] + Vec3(0.1, 0.1, 0.0)},
                                      {poses.p_0B[4] + Vec3(0.0, 0.1, 0.1)}};
  bool slerped = false;
  for (int step = 0; step < 700; ++step) {
    Period period{near_goal(generator, rig), rig.scene(), step * rig.period,
                  controller->theta(),       nullptr,     controller.get()};
    if (step >= 450 && step < 550) period.scene.obstacles = near;
    if (step >= 500) period.scene.target.position += Vec3(0.4, 0.3, 0.2);
    period.out = &controller->update(period.measured, period.scene, period.time);
    slerped = slerped || period.out->slerping;
    check(period);
  }
  EXPECT_TRUE(slerped);
}

test::Rig moving_rig() {
  test::Rig rig;
  rig.path.frequency = 0.5;
  rig.path.terms = {{1, Vec3(0.05, 0, 0), Vec3(0, 0.05, 0)}};
  return rig;
}

SlotineLi motion_of(const Period& p, const Chain& chain, const Poses& poses) {
  SlotineLi motion;
  slotine_li_forward(chain, poses, p.measured.qd, p.out->reference.velocity, p.out->reference.acceleration,
                     motion);
  return motion;
}

TEST(Controller, CommandsMinusKdSPlusYThetaPlusRepulsionAndSaturatesIt) {
  const test::Rig rig = moving_rig();
  const Chain& chain = rig.model->chain;
  const JointVector limits = rig.model->effort_limits();
  WorstError worst("torque", 1e-11);  // rounding
  drive(rig, [&](const Period& p) {
    const ControlOutput& out = *p.out;
    const Poses poses = test::poses_at(chain, p.measured.q);
    Regressor Y;
    slotine_li_regressor(chain, poses, motion_of(p, chain, poses), Y);
    JointVector Kd = out.state == ControlState::kLeaveSingularity ? rig.gains.joint_space_gains_d
                                                                  : rig.gains.task_space_gains_d;
    if (out.slerping) Kd.tail<3>() *= rig.gains.interpolation_gain_scale;
    const JointVector S = p.measured.qd - out.reference.velocity;
    JointVector expected = Y * p.theta_before - Kd.cwiseProduct(S);
    if (out.state == ControlState::kAvoidObstacles) {
      JointVector repulsion_torque;
      obstacle_torque(chain, poses, p.scene.obstacles, rig.gains.obstacleInfluenceRadius,
                      rig.gains.force_control_gains, repulsion_torque);
      EXPECT_GT(repulsion_torque.norm(), 0.1);
      expected += repulsion_torque;
    }
    EXPECT_EQ(out.S, S);
    worst.compare(out.commanded, expected, name(out.state));
    for (int i = 0; i < 6; ++i) EXPECT_EQ(out.torque[i], std::clamp(out.commanded[i], -limits[i], limits[i]));
    EXPECT_EQ(out.saturated, (out.commanded.cwiseAbs().array() > limits.array()).any());
  });
}

TEST(Controller, AdaptsThetaWithTheRegressorOfThePeriod) {
  const test::Rig rig = moving_rig();
  WorstError worst("theta step", 1e-9);  // theta is some 1e4 times larger than its step: rounding
  drive(rig, [&](const Period& p) {
    const Poses poses = test::poses_at(rig.model->chain, p.measured.q);
    Regressor Y;
    slotine_li_regressor(rig.model->chain, poses, motion_of(p, rig.model->chain, poses), Y);
    const ParameterVector step = -rig.gains.adaptation_gain * rig.period * (Y.transpose() * p.out->S);
    const ParameterVector expected = p.out->saturated ? ParameterVector::Zero(step.size()) : step;
    worst.compare(ParameterVector(p.controller->theta() - p.theta_before), expected, name(p.out->state),
                  1e-3);
  });
}

TEST(Controller, UsesTheCartesianReferencesOfItsErrorsWithRotationalKpScaledInASlerp) {
  const test::Rig rig = moving_rig();
  const Chain& chain = rig.model->chain;
  WorstError velocity("J qr' = xr'", 1e-11);  // condition of J, some 10
  WorstError acceleration("J qr'' + J' qr' = xr''", 1e-11);
  drive(rig, [&](const Period& p) {
    const ControlOutput& out = *p.out;
    if (out.state == ControlState::kLeaveSingularity) return;
    ASSERT_FALSE(out.damped);
    const CartesianErrors& x = out.errors;
    Vec6 Kp = rig.gains.task_space_gains_p;
    if (out.slerping) Kp.tail<3>() *= rig.gains.interpolation_gain_scale;
    const Vec6 Ki = rig.gains.task_space_gains_i;
    const Jacobian J = test::tool_jacobian_at(chain, p.measured.q);
    Jacobian J_dot;
    tool_jacobian_derivative(chain, test::poses_at(chain, p.measured.q), J, p.measured.qd, J_dot);
    const Vec6 xr_dot = x.desired_rate - Kp.cwiseProduct(x.pose) - Ki.cwiseProduct(x.integral);
    const Vec6 xr_ddot = x.desired_accel - Kp.cwiseProduct(x.rate) - Ki.cwiseProduct(x.pose);
    velocity.compare(Vec6(J * out.reference.velocity), xr_dot, name(out.state));
    acceleration.compare(Vec6(J * out.reference.acceleration + J_dot * out.reference.velocity), xr_ddot,
                         name(out.state));
  });
}

TEST(Controller, ErrorsAreMeasuredMinusDesired) {
  const test::Rig rig = moving_rig();
  const Chain& chain = rig.model->chain;
  WorstError worst("errors", 1e-12);  // rounding
  drive(rig, [&](const Period& p) {
    const ControlOutput& out = *p.out;
    if (out.state != ControlState::kFollowTrajectory) return;
    const Poses poses = test::poses_at(chain, p.measured.q);
    const MotionPoint<Vec3> d = rig.path.at(p.time);
    const Vec6 twist = test::tool_jacobian_at(chain, p.measured.q) * p.measured.qd;
    const Eigen::AngleAxisd turn(
        Mat3(out.desired_gaze.orientation.toRotationMatrix() * poses.R_0T.transpose()));
    Vec6 pose, desired_rate, desired_accel;
    pose << poses.p_0T - d.position, -turn.angle() * turn.axis();
    desired_rate << d.velocity, out.desired_gaze.angular_velocity;
    desired_accel << d.acceleration, out.desired_gaze.angular_acceleration;
    worst.compare(out.errors.pose, pose, "dx", 1e-3);
    worst.compare(out.errors.desired_rate, desired_rate, "xd'");
    worst.compare(out.errors.desired_accel, desired_accel, "xd''");
    worst.compare(out.errors.rate, Vec6(twist - desired_rate), "dx'");
  });
}

TEST(Controller, AimsTheReferenceVelocityAgainstThePositionError) {
  test::Rig rig;
  double time = 0.0;
  const std::unique_ptr<Controller> controller = rig.following(time);
  for (int axis = 0; axis < 3; ++axis) {
    rig.path.center += 0.05 * Vec3::Unit(axis);  // the path leaves; the tool stays
    const ControlOutput& out = controller->update(rig.goal(), rig.scene(), time += rig.period);
    ASSERT_EQ(out.state, ControlState::kFollowTrajectory);
    const Vec3 error = test::poses_at(rig.model->chain, rig.goal().q).p_0T - rig.path.center;
    const Vec3 v =
        Vec6(test::tool_jacobian_at(rig.model->chain, rig.goal().q) * out.reference.velocity).head<3>();
    EXPECT_LT(v.dot(error), 0.0) << axis;
    EXPECT_LT(v[axis] * error[axis], 0.0) << axis;
  }
}

TEST(Controller, AimsTheReferenceTurnAtTheTarget) {
  for (const double aside : {0.05, 0.5}) {  // below and, in its middle, within a slerp
    test::Rig rig;
    double time = 0.0;
    const std::unique_ptr<Controller> controller = rig.following(time);
    rig.p_0G += Vec3(aside, 0.7 * aside, 0.0);
    controller->update(rig.goal(), rig.scene(), time);
    const ControlOutput& out = controller->update(rig.goal(), rig.scene(), time + 0.3);
    EXPECT_EQ(out.slerping, aside > 0.1);
    const Poses poses = test::poses_at(rig.model->chain, rig.goal().q);
    const Vec3 w =
        Vec6(test::tool_jacobian_at(rig.model->chain, rig.goal().q) * out.reference.velocity).tail<3>();
    const Vec3 z = poses.R_0T.col(2);
    const Vec3 line = (rig.p_0G - poses.p_0T).normalized();
    EXPECT_GT(w.cross(z).dot(line - z), 0.0) << aside;
  }
}

TEST(Controller, FollowsTheJointSpaceLawWhileLeavingTheSingularity) {
  test::Rig rig;
  std::mt19937 generator(612);
  const std::unique_ptr<Controller> controller = rig.controller();
  const JointVector start = rig.goal().q + JointVector::Constant(6, 0.3);
  WorstError worst("references", 1e-12);  // rounding
  for (double time = 0.0; time < 0.5; time += rig.period) {
    JointState measured{start, test::random_vector(generator, 6, 0.1)};
    if (time > 0.0) measured.q += test::random_vector(generator, 6, 0.1);
    const ControlOutput& out = controller->update(measured, rig.scene(), time);
    ASSERT_EQ(out.state, ControlState::kLeaveSingularity);
    const MotionPoint<JointVector> d = joint_trajectory(start, rig.goal().q, 0.5, time);
    const JointVector& Kp = rig.gains.joint_space_gains_p;
    worst.compare(out.reference.velocity, JointVector(d.velocity - Kp.cwiseProduct(measured.q - d.position)),
                  "qr'", 1.0);
    worst.compare(out.reference.acceleration,
                  JointVector(d.acceleration - Kp.cwiseProduct(measured.qd - d.velocity)), "qr''", 1.0);
  }
}

TEST(Controller, ClampsTheTorqueAndHoldsThetaAndIntegralStillWhileSaturated) {
  test::Rig rig;
  double time = 0.0;
  const std::unique_ptr<Controller> controller = rig.following(time);
  rig.path.center += Vec3(0.01, 0.02, -0.01);
  for (int step = 0; step < 5; ++step) controller->update(rig.goal(), rig.scene(), time += rig.period);
  JointState fast = rig.goal();
  fast.qd << 5, -5, 5, 5, -5, 20;
  const ParameterVector theta = controller->theta();
  Vec6 integral = Vec6::Zero();
  for (int step = 0; step < 5; ++step) {
    const ControlOutput& out = controller->update(fast, rig.scene(), time += rig.period);
    ASSERT_TRUE(out.saturated);
    EXPECT_TRUE((out.torque.cwiseAbs().array() <= rig.model->effort_limits().array()).all());
    EXPECT_EQ(std::abs(out.torque[0]), 330.0);
    EXPECT_LT(out.torque[0] * fast.qd[0], 0.0);
    EXPECT_EQ(controller->theta(), theta);
    if (step > 0) {
      EXPECT_EQ(out.errors.integral, integral);
    }
    integral = out.errors.integral;
    EXPECT_GT(integral.norm(), 0.0);
  }
  const ControlOutput& out = controller->update(rig.goal(), rig.scene(), time += rig.period);
  EXPECT_FALSE(out.saturated);
  EXPECT_EQ(out.errors.integral, integral);
  EXPECT_NE(controller->theta(), theta);
}

TEST(Controller, StartsThetaWhereItIsTold) {
  const test::Rig rig;
  const ParameterVector theta = 0.7 * theta_of(rig.model->chain);
  EXPECT_EQ(rig.controller(theta)->theta(), theta);
}

}  // namespace controller_test
}  // namespace armtune::internal
