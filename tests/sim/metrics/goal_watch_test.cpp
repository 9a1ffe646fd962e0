#include "sim/metrics/goal_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace armtune::internal {
namespace goal_watch_test {

JointVector joints(double a, double b) {
  JointVector q(2);
  q << a, b;
  return q;
}

/// Joint 0 moves from 0 to 1 and joint 1 from 0 to -0.5, between 1 s and 3 s.
JointSpline plan() {
  const JointVector zero = JointVector::Zero(2);
  return JointSpline({1.0, 3.0}, {{zero, zero, zero}, {joints(1.0, -0.5), zero, zero}},
                     PointsGive::kVelocities);
}

Metrics of(GoalWatch& watch, double end) {
  Metrics m;
  watch.write(end, m);
  return m;
}

// About the goal, the error of joint 0 is a decaying oscillation whose extremes are known.
TEST(GoalWatch, MeasuresSettlingTimeAndOvershootOfADecayingOscillation) {
  for (const double sign : {1.0, -1.0}) {
    GoalWatch watch(plan(), 0.01);
    constexpr double kStep = 1e-3, kDecay = 2.0, kPeriod = 0.5;
    for (int k = 0; k <= 6000; ++k) {
      const double t = k * kStep, past = t - 3.0;
      // Before the end of the plan the arm is far away, which must not count.
      const double error =
          past < 0.0 ? 5.0 : sign * 0.2 * std::exp(-kDecay * past) * std::cos(2.0 * M_PI * past / kPeriod);
      watch.add(t, joints(1.0 + error, -0.5));
    }
    const Metrics m = of(watch, 6.0);
    // The largest |error| in each half oscillation falls below 0.01 near ln(20)/2 = 1.498 s: the last time
    // outside is shortly before the zero at 1.375 s or 1.625 s.
    EXPECT_GT(m[Metric::kGoalSettlingTime], 1.375);
    EXPECT_LT(m[Metric::kGoalSettlingTime], 1.625);
    const double extreme = 0.2 * std::exp(-kDecay * m[Metric::kGoalSettlingTime]);
    EXPECT_LE(extreme * std::abs(std::cos(2.0 * M_PI * m[Metric::kGoalSettlingTime] / kPeriod)), 0.01);
    // Joint 0 comes from below. With the other sign it passes the goal half an oscillation later.
    EXPECT_NEAR(m[Metric::kGoalOvershoot], sign > 0.0 ? 0.2 : 0.2 * std::exp(-kDecay * 0.246), 2e-3);
  }
}

TEST(GoalWatch, OvershootIsInTheDirectionInWhichTheJointCame) {
  GoalWatch watch(plan(), 0.01);
  watch.add(3.0, joints(0.9, -0.3));
  EXPECT_EQ(of(watch, 3.0)[Metric::kGoalOvershoot], 0.0) << "both have not arrived";
  watch.add(3.1, joints(0.9, -0.55));
  EXPECT_NEAR(of(watch, 3.1)[Metric::kGoalOvershoot], 0.05, 1e-15) << "joint 1 comes from above";
}

TEST(GoalWatch, AJointThatDoesNotMoveHasNoOvershootButMustSettle) {
  const JointVector zero = JointVector::Zero(2);
  GoalWatch watch(
      JointSpline({0.0, 1.0}, {{zero, zero, zero}, {joints(1.0, 0.0), zero, zero}}, PointsGive::kVelocities),
      0.01);
  for (int k = 0; k < 10; ++k) watch.add(1.0 + 0.1 * k, joints(1.0, k < 4 ? 0.02 : -0.005));
  EXPECT_EQ(of(watch, 2.0)[Metric::kGoalOvershoot], 0.0);
  EXPECT_NEAR(of(watch, 2.0)[Metric::kGoalSettlingTime], 0.4, 1e-12);
}

TEST(GoalWatch, ItIsTheLastDirectionThatCounts) {
  const JointVector zero = JointVector::Zero(2);
  // Joint 0 goes to 2 and comes back to 1 from above.
  GoalWatch watch(
      JointSpline({0.0, 1.0, 2.0},
                  {{zero, zero, zero}, {joints(2.0, 0.0), zero, zero}, {joints(1.0, 0.0), zero, zero}},
                  PointsGive::kVelocities),
      0.01);
  watch.add(2.0, joints(1.3, 0.0));
  EXPECT_EQ(of(watch, 2.0)[Metric::kGoalOvershoot], 0.0);
  watch.add(2.1, joints(0.8, 0.0));
  EXPECT_NEAR(of(watch, 2.1)[Metric::kGoalOvershoot], 0.2, 1e-15);
}

TEST(GoalWatch, IsEmptyBeforeTheEndAndTheWholeTimeIfItNeverSettles) {
  GoalWatch watch(plan(), 0.01);
  watch.add(2.999, joints(5.0, 5.0));
  EXPECT_TRUE(std::isnan(of(watch, 3.0)[Metric::kGoalSettlingTime]));
  EXPECT_TRUE(std::isnan(of(watch, 3.0)[Metric::kGoalOvershoot]));
  watch.add(3.0, joints(1.0, -0.5));
  EXPECT_EQ(of(watch, 3.1)[Metric::kGoalSettlingTime], 0.0) << "settled from the first time on";
  watch.add(3.5, joints(1.0, -0.2));
  EXPECT_EQ(of(watch, 4.0)[Metric::kGoalSettlingTime], 1.0);
}

}  // namespace goal_watch_test
}  // namespace armtune::internal
