// What the controller does with a planned trajectory.
#include <gtest/gtest.h>

#include <random>

#include "core/control/joint_space_law.hpp"
#include "core/control/laws/controller.hpp"
#include "core/robot/theta.hpp"
#include "core/trajectory/linear_acceleration.hpp"
#include "tests/core/support/allocation_counter.hpp"
#include "tests/core/support/controller_rig.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace controller_plan_test {

using test::WorstError;

/// From the beginning of `motion` with its accelerations at knots h apart: what linear ones in between
/// integrate to.
template <typename F>
JointSpline sampled(const F& motion, double begin, double end, double h) {
  std::vector<double> time;
  std::vector<MotionPoint<JointVector>> knots = {motion(begin)};
  const int intervals = static_cast<int>(std::lround((end - begin) / h));
  for (int k = 0; k <= intervals; ++k) {
    time.push_back(begin + (end - begin) * k / intervals);
    if (k == 0) continue;
    const double step = time.back() - time[time.size() - 2];
    knots.push_back(linear_acceleration(knots.back(), motion(time.back()).acceleration, step, step));
  }
  return {time, knots};
}

/// From the goal, and back to it: each joint a sine of its own about it, at rest in neither.
MotionPoint<JointVector> sway(const test::Rig& rig, double t) {
  MotionPoint<JointVector> point{rig.goal().q, JointVector::Zero(6), JointVector::Zero(6)};
  for (int i = 0; i < 6; ++i) {
    const double a = 0.1 + 0.02 * i;
    const double w = 2.0 + 0.3 * i;
    point.position[i] += a * std::sin(w * t);
    point.velocity[i] = a * w * std::cos(w * t);
    point.acceleration[i] = -a * w * w * std::sin(w * t);
  }
  return point;
}

constexpr double kBegin = 8.0;
constexpr double kEnd = 9.0;

struct PlannedRig : test::Rig {
  JointSpline plan = sampled([this](double t) { return sway(*this, t); }, kBegin, kEnd, 0.01);
  Scene scene() const {
    Scene scene = Rig::scene();
    scene.plan = &plan;
    return scene;
  }
  JointState on_plan(double t) const { return {plan.at(t).position, plan.at(t).velocity}; }
};

TEST(ControllerPlan, IsFollowedFromTheFirstPeriodOnAndLeftForTheReturnAtItsEnd) {
  const PlannedRig rig;
  const auto controller = rig.controller();
  const auto state_at = [&](double t) { return controller->update(rig.on_plan(t), rig.scene(), t).state; };
  EXPECT_EQ(state_at(kBegin), ControlState::kFollowPlan);
  EXPECT_EQ(state_at(kEnd - 0.001), ControlState::kFollowPlan);
  EXPECT_EQ(state_at(kEnd), ControlState::kReturnToTrajectory);
}

TEST(ControllerPlan, WithoutOneNothingChanges) {
  const test::Rig rig;
  EXPECT_EQ(rig.controller()->update(rig.goal(), rig.scene(), 0.0).state, ControlState::kLeaveSingularity);
}

TEST(ControllerPlan, TheReferenceIsTheJointSpaceLawsWithTheMeanAccelerationOfThePeriod) {
  const PlannedRig rig;
  const auto controller = rig.controller();
  std::mt19937 generator(561);
  WorstError velocity("qr'", 1e-14);       // rounding
  WorstError acceleration("qr''", 1e-11);  // of velocities over 2 ms
  WorstError torque("tau", 1e-11);
  for (double t = kBegin; t < kEnd - 0.1; t += 0.0317) {
    JointState measured = rig.on_plan(t);
    measured.q += test::random_vector(generator, 6, 0.05);
    measured.qd += test::random_vector(generator, 6, 0.1);
    const ParameterVector theta = controller->theta();
    const ControlOutput& out = controller->update(measured, rig.scene(), t);
    ASSERT_EQ(out.state, ControlState::kFollowPlan);
    const JointVector& Kp = rig.gains.joint_space_gains_p;
    const MotionPoint<JointVector> d = rig.plan.at(t);
    const JointVector mean = (rig.plan.at(t + rig.period).velocity - d.velocity) / rig.period;
    const JointVector qr = d.velocity - Kp.cwiseProduct(measured.q - d.position);
    const JointVector qr_dot = mean - Kp.cwiseProduct(measured.qd - d.velocity);
    velocity.compare(out.reference.velocity, qr, "followPlan");
    acceleration.compare(out.reference.acceleration, qr_dot, "followPlan");
    EXPECT_EQ(out.planned.position, d.position);
    const Poses poses = test::poses_at(rig.model->chain, measured.q);
    SlotineLi motion;
    slotine_li_forward(rig.model->chain, poses, measured.qd, qr, qr_dot, motion);
    Regressor Y;
    slotine_li_regressor(rig.model->chain, poses, motion, Y);
    torque.compare(out.commanded,
                   JointVector(Y * theta - rig.gains.joint_space_gains_d.cwiseProduct(measured.qd - qr)),
                   "tau");
    EXPECT_TRUE(out.errors.pose.isZero(0.0));
    EXPECT_FALSE(out.slerping);
  }
}

/// The quintic of leaveSingularity, once by its own state and once as a plan with knots h apart, from the
/// same measured states: what the two laws ask for differs by the interpolation and by half a period of jerk.
double largest_difference(double h, double period) {
  test::Rig rig;
  rig.period = period;
  const JointVector start = rig.goal().q + JointVector::Constant(6, 0.3);
  const double duration = rig.gains.joint_trajectory_duration;
  const JointSpline plan =
      sampled([&](double t) { return joint_trajectory(start, rig.goal().q, duration, t); }, 0.0, duration, h);
  Scene with = rig.scene();
  with.plan = &plan;
  const auto by_plan = rig.controller();
  const auto by_itself = rig.controller();
  std::mt19937 generator(562);
  double worst = 0.0;
  for (int step = 0; step * period < duration - 1e-9; ++step) {
    const double t = step * period;
    const MotionPoint<JointVector> d = joint_trajectory(start, rig.goal().q, duration, t);
    const JointState measured = step == 0 ? JointState{d.position, d.velocity}
                                          : JointState{d.position + test::random_vector(generator, 6, 0.01),
                                                       d.velocity + test::random_vector(generator, 6, 0.1)};
    const JointReference planned = by_plan->update(measured, with, t).reference;
    const ControlOutput& own = by_itself->update(measured, rig.scene(), t);
    EXPECT_EQ(own.state, ControlState::kLeaveSingularity);
    worst = std::max({worst, (planned.velocity - own.reference.velocity).lpNorm<Eigen::Infinity>(),
                      (planned.acceleration - own.reference.acceleration).lpNorm<Eigen::Infinity>()});
  }
  return worst;
}

TEST(ControllerPlan, AQuinticFollowedAsAPlanIsLeaveSingularitysButForKnotsAndHalfAPeriod) {
  // Largest jerk of 0.3 rad in 0.5 s: 60 * 0.3 / 0.5^3 = 144 rad/s^3.
  const double jerk = 144.0;
  for (const double period : {2e-3, 5e-4}) {
    const double difference = largest_difference(2e-4, period);
    EXPECT_LT(difference, 1.02 * jerk * period / 2.0);
    EXPECT_GT(difference, 0.9 * jerk * period / 2.0);
  }
  // The interpolation's share is of second order in the distance of the knots.
  const double tiny = 5e-4;
  const double coarse = largest_difference(5e-2, tiny);
  EXPECT_LT(coarse, 3.0);
  EXPECT_NEAR(largest_difference(2.5e-2, tiny), 0.25 * coarse, 0.05 * coarse);
}

TEST(ControllerPlan, AnObstacleInterruptsItForGood) {
  PlannedRig rig;
  const auto controller = rig.controller();
  const Vec3 elbow = test::poses_at(rig.model->chain, rig.goal().q).p_0B[2] + Vec3(0.1, 0.1, 0.0);
  const auto state_at = [&](double t) { return controller->update(rig.on_plan(t), rig.scene(), t).state; };
  EXPECT_EQ(state_at(kBegin), ControlState::kFollowPlan);
  rig.obstacles = {{elbow}};
  EXPECT_EQ(state_at(kBegin + 0.1), ControlState::kAvoidObstacles);
  rig.obstacles.clear();
  EXPECT_EQ(state_at(kBegin + 0.2), ControlState::kReturnToTrajectory);
  EXPECT_NE(state_at(kBegin + 0.3), ControlState::kFollowPlan);
}

TEST(ControllerPlan, TheReturnThatComesNextGoesOnWithTheToolsAccelerationOnThePlan) {
  const PlannedRig rig;
  const auto controller = rig.controller();
  const double last = kEnd - 0.5 * rig.period;
  controller->update(rig.on_plan(last), rig.scene(), last);
  const ControlOutput& out = controller->update(rig.on_plan(kEnd), rig.scene(), kEnd);
  ASSERT_EQ(out.state, ControlState::kReturnToTrajectory);
  const auto tool = [&](double d) {
    return Vec3(test::poses_at(rig.model->chain, rig.plan.at(last + d).position).p_0T);
  };
  const double h = 0.2e-3;  // inside the last interval of the plan
  const Vec3 acceleration = (tool(h) - 2.0 * tool(0.0) + tool(-h)) / (h * h);
  EXPECT_GT(acceleration.norm(), 0.5);
  // Half a period between the two, and the mean over what was left of the plan: some 3 m/s^3.
  EXPECT_LT((out.desired.acceleration - acceleration).norm(), 0.01);
}

TEST(ControllerPlan, GovernorAndBarrierLeaveItAlone) {
  PlannedRig rig;
  const auto plain = rig.controller();
  rig.gains.velocity_margin = 0.01;
  rig.gains.velocity_barrier_start = 0.01;
  rig.gains.velocity_barrier_gain = 1.0;
  const auto guarded = rig.controller();
  for (double t = kBegin; t < kEnd; t += 0.1) {
    const JointVector torque = plain->update(rig.on_plan(t), rig.scene(), t).commanded;
    const ControlOutput& out = guarded->update(rig.on_plan(t), rig.scene(), t);
    EXPECT_EQ(out.pace, 1.0);
    EXPECT_EQ(out.commanded, torque);
  }
}

TEST(ControllerPlan, AllocatesNothing) {
  if (!test::allocations_are_counted()) GTEST_SKIP() << "a sanitizer owns malloc";
  const PlannedRig rig;
  const auto controller = rig.controller();
  const Scene scene = rig.scene();
  for (double t = kBegin; t < kEnd; t += 0.05) {
    const JointState measured = rig.on_plan(t);
    const long before = test::allocations();
    const ControlOutput& out = controller->update(measured, scene, t);
    EXPECT_EQ(test::allocations(), before);
    ASSERT_EQ(out.state, ControlState::kFollowPlan);
  }
}

}  // namespace controller_plan_test
}  // namespace armtune::internal
