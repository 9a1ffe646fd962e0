#include "sim/rollout/true_state.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/trajectory/gaze.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune {
namespace {

Eigen::AngleAxisd turn_by(const Vec3& vector) {
  const double angle = vector.norm();
  return {angle, angle > 0.0 ? Vec3(vector / angle) : Vec3(Vec3::UnitX())};
}

TEST(TrueState, OrientationErrorsAreAgainstTheGazeAndInASlerpAgainstTheSlerp) {
  const Scenario scenario = test::scenario_of("target_switch", 12.0);
  int slerping = 0;
  int direct = 0;
  Rollout(scenario, Stepper::kMidpoint).run(test::quick_gains(scenario), [&](const Observation& o) {
    if (o.control->state == ControlState::kLeaveSingularity) {
      EXPECT_TRUE(o.error.isZero(0.0));
      return true;
    }
    EXPECT_NEAR(o.gaze_angle, gaze_angle(o.poses->R_0T, o.poses->p_0T, o.target_motion.position), 1e-15);
    // The error is the turn from the desired orientation to the true one.
    const Mat3 desired = turn_by(o.error.tail<3>()).inverse() * o.poses->R_0T;
    if (o.control->slerping) {
      ++slerping;
      EXPECT_LT((desired - o.control->desired_gaze.orientation.toRotationMatrix()).norm(), 1e-9);
    } else {
      ++direct;
      const Vec3 line = (o.target_motion.position - o.poses->p_0T).normalized();
      EXPECT_LT((desired.col(2) - line).norm(), 1e-9) << "what is desired looks at the target";
      EXPECT_NEAR(o.error.tail<3>().norm(), o.gaze_angle, 1e-12) << "by the shortest turn";
    }
    return true;
  });
  EXPECT_GT(slerping, 100);
  EXPECT_GT(direct, 100);
}

TEST(TrueState, TwistIsTheDerivativeOfThePose) {
  const Scenario scenario = test::scenario_of("moving_target", 5.0);
  const double h = scenario.control_period;
  Vec3 p = Vec3::Zero(), v = Vec3::Zero();
  double worst = 0.0;
  Rollout(scenario, Stepper::kMidpoint).run(test::quick_gains(scenario), [&](const Observation& o) {
    if (o.time > 0.0) {
      worst = std::max(worst, (o.poses->p_0T - p - 0.5 * h * (o.twist.head<3>() + v)).norm());
    }
    p = o.poses->p_0T;
    v = o.twist.head<3>();
    return true;
  });
  EXPECT_LT(worst, 1e-5) << "the trapezoidal rule leaves h^3";
}

TEST(TrueState, CompensationIsExactWhereThetaIsTheArm) {
  Scenario scenario = test::scenario_of("moving_target", 5.0);
  scenario.theta.model_scale = 1.0;
  Gains gains = test::quick_gains(scenario);
  gains.adaptation_gain = 0.0;
  EXPECT_LT(Rollout(scenario, Stepper::kMidpoint).run(gains).metrics[Metric::kCompensationErrorRms], 1e-9);
  scenario.plant.payload.mass = 1.0;  // the truth is that of the plant
  EXPECT_GT(Rollout(scenario, Stepper::kMidpoint).run(gains).metrics[Metric::kCompensationErrorRms], 1.0);
}

TEST(TrueState, ObstacleDistanceIsThatOfTheClosestJoint) {
  const Scenario scenario = test::scenario_of("obstacle_pass", 1.0);
  Rollout(scenario, Stepper::kMidpoint).run(test::quick_gains(scenario), [&](const Observation& o) {
    double closest = HUGE_VAL;
    for (const NamedPath& obstacle : scenario.obstacles) {
      for (int i = 0; i < o.poses->n; ++i) {
        closest = std::min(
            closest, (o.poses->p_0B[static_cast<std::size_t>(i)] - obstacle.path.at(o.time).position).norm());
      }
    }
    EXPECT_NEAR(o.obstacle_distance, closest, 1e-12);
    return true;
  });
}

}  // namespace
}  // namespace armtune
