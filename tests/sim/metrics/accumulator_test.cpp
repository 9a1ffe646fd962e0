#include "sim/metrics/accumulator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/core/support/arms.hpp"

namespace armtune::internal {
namespace accumulator_test {

using enum ControlState;

TEST(Spread, IsTheRootMeanSquareAndTheLargestMagnitude) {
  Spread spread;
  EXPECT_TRUE(std::isnan(spread.rms()));
  EXPECT_TRUE(std::isnan(spread.max()));
  for (const double x : {3.0, -4.0, 0.0, 0.0}) spread.add(x);
  EXPECT_DOUBLE_EQ(spread.rms(), 2.5);
  EXPECT_EQ(spread.max(), 4.0);
  EXPECT_EQ(spread.count(), 4);
}

constexpr double kPeriod = 0.1;
constexpr double kThreshold = 0.15;

/// One period made by hand, at rest and on target unless a test says otherwise.
struct Period {
  explicit Period(const RobotModel& model) {
    q = JointVector::Zero(model.n());
    qd = JointVector::Zero(model.n());
    control.torque = control.commanded = JointVector::Zero(model.n());
    control.state = kFollowTrajectory;
    o.q = &q;
    o.qd = &qd;
    o.control = &control;
    o.poses = &poses;
    o.target_motion = {Vec3(0.0, 0.0, 1.0), Vec3::Zero(), Vec3::Zero()};  // straight ahead of the tool
    o.clearance = std::numeric_limits<double>::infinity();
  }
  JointVector q, qd;
  ControlOutput control;
  Poses poses;
  Observation o;
};

class Accumulated : public testing::Test {
 protected:
  void add(int count = 1) {
    for (int i = 0; i < count; ++i) {
      p_.o.time = kPeriod * k_++;
      metrics_.add(p_.o);
    }
  }
  /// A second in followTrajectory: from here on tracking counts.
  void settle() { add(10); }
  Metrics result() { return metrics_.result(kPeriod * k_); }

  const RobotModel model_ = test::ur10();
  Period p_{model_};
  MetricAccumulator metrics_{model_, kThreshold, kPeriod};
  int k_ = 0;
};

TEST_F(Accumulated, AFigureOfNoPeriodIsEmptyAndNotZero) {
  const Metrics none = MetricAccumulator(metrics_).result(0.0);
  for (const Metric m : all_metrics()) {
    if (m != Metric::kSamples) {
      EXPECT_TRUE(std::isnan(none[m])) << name(m);
    }
  }
  EXPECT_EQ(none.max_ratio_joint, "");
  add();
  EXPECT_EQ(result()[Metric::kJointVelocityMaxRatio], 0.0) << "an arm at rest";
}

TEST_F(Accumulated, TrackingCountsFromOneSecondAfterFollowTrajectoryWasEntered) {
  p_.o.error.setConstant(9.0);
  p_.control.state = kLeaveSingularity;
  add(20);
  p_.control.state = kReturnToTrajectory;
  add(20);
  p_.control.state = kFollowTrajectory;
  add(10);
  EXPECT_EQ(MetricAccumulator(metrics_).result(0.0)[Metric::kSamples], 0.0);
  p_.o.error.setConstant(0.5);
  add(7);
  const Metrics m = result();
  EXPECT_EQ(m[Metric::kSamples], 7.0);
  EXPECT_EQ(m[Metric::kPositionXMax], 0.5);
  EXPECT_EQ(m[Metric::kOrientationZMax], 0.5);
}

TEST_F(Accumulated, TrackingPausesWhileASlerpRunsAndBeginsAnewAfterAnotherState) {
  settle();
  add(3);
  p_.control.slerping = true;
  add(5);
  p_.control.slerping = false;
  add(2);
  p_.control.state = kAvoidObstacles;
  add(5);
  p_.control.state = kFollowTrajectory;
  add(10);  // the second after it was entered again
  add(4);
  EXPECT_EQ(result()[Metric::kSamples], 3.0 + 2.0 + 4.0);
}

TEST_F(Accumulated, EveryAxisHasItsLargestAndAllTogetherTheNorm) {
  settle();
  p_.o.error << 0.3, 0.0, -0.4, 0.02, -0.03, 0.06;
  p_.o.error_rate << 0.0, 3.0, 4.0, 0.6, 0.0, 0.8;
  add();
  p_.o.error << -0.1, 0.2, 0.2, 0.0, 0.0, 0.0;
  p_.o.error_rate.setZero();
  add();
  const Metrics m = result();
  EXPECT_EQ(m[Metric::kPositionXMax], 0.3);
  EXPECT_EQ(m[Metric::kPositionYMax], 0.2);
  EXPECT_EQ(m[Metric::kPositionZMax], 0.4);
  EXPECT_DOUBLE_EQ(m[Metric::kPositionMax], 0.5);
  EXPECT_DOUBLE_EQ(m[Metric::kPositionRms], std::sqrt((0.25 + 0.09) / 2.0));
  EXPECT_EQ(m[Metric::kOrientationXMax], 0.02);
  EXPECT_EQ(m[Metric::kOrientationYMax], 0.03);
  EXPECT_EQ(m[Metric::kOrientationZMax], 0.06);
  EXPECT_DOUBLE_EQ(m[Metric::kOrientationMax], 0.07);
  EXPECT_DOUBLE_EQ(m[Metric::kOrientationRms], 0.07 / std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(m[Metric::kLinearVelocityMax], 5.0);
  EXPECT_DOUBLE_EQ(m[Metric::kLinearVelocityRms], 5.0 / std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(m[Metric::kAngularVelocityMax], 1.0);
  EXPECT_DOUBLE_EQ(m[Metric::kAngularVelocityRms], 1.0 / std::sqrt(2.0));
}

TEST_F(Accumulated, JointErrorsAreThoseToThePlanOverJointsAndTime) {
  p_.control.planned = {JointVector::Zero(6), JointVector::Zero(6), JointVector::Zero(6)};
  p_.control.planned.position[1] = 0.5;
  p_.q.setConstant(9.0);
  add();  // in followTrajectory there is no plan
  p_.control.state = kFollowPlan;
  p_.q.setZero();
  p_.q[1] = 0.4;  // 0.1 behind it
  add();
  p_.q[1] = 0.5;
  p_.q[4] = -0.2;
  add();
  const Metrics m = result();
  EXPECT_NEAR(m[Metric::kJointErrorMax], 0.2, 1e-12);
  EXPECT_NEAR(m[Metric::kJointErrorRms], std::sqrt((0.1 * 0.1 + 0.2 * 0.2) / 12.0), 1e-12);
}

TEST_F(Accumulated, ToolErrorsAreDistancesFromTheToolOfThePlannedPositions) {
  p_.control.planned = {JointVector::Constant(6, 0.3), JointVector::Zero(6), JointVector::Zero(6)};
  forward_kinematics(model_.chain, p_.control.planned.position, p_.poses);
  const Vec3 planned = p_.poses.p_0T;
  p_.poses.p_0T.setConstant(9.0);
  add();  // in followTrajectory there is no plan
  p_.control.state = kFollowPlan;
  p_.poses.p_0T = planned + Vec3(0.03, 0.0, -0.04);
  add();
  p_.poses.p_0T = planned;
  add();
  const Metrics m = result();
  EXPECT_NEAR(m[Metric::kToolErrorMax], 0.05, 1e-12);
  EXPECT_NEAR(m[Metric::kToolErrorRms], 0.05 / std::sqrt(2.0), 1e-12);
}

TEST_F(Accumulated, TheLargestVelocityRatioNamesJointAndTime) {
  p_.control.state = kLeaveSingularity;  // limits count always
  add(3);
  p_.qd[1] = -0.5 * model_.joints[1].limits.velocity;
  add();
  p_.qd[1] = 0.0;
  p_.qd[4] = 0.8 * model_.joints[4].limits.velocity;
  add();
  p_.qd[4] *= 0.5;
  add(3);
  const Metrics m = result();
  EXPECT_DOUBLE_EQ(m[Metric::kJointVelocityMaxRatio], 0.8);
  EXPECT_EQ(m.max_ratio_joint, model_.joints[4].name);
  EXPECT_DOUBLE_EQ(m[Metric::kJointVelocityMaxRatioTime], 0.4);
}

TEST_F(Accumulated, TheSmallestMarginIsThatOfTheClosestLimitAndNegativeBeyond) {
  const JointLimits& elbow = model_.joints[2].limits;
  p_.q[2] = elbow.upper - 0.3;
  add();
  EXPECT_NEAR(MetricAccumulator(metrics_).result(0.0)[Metric::kJointPositionMinMargin], 0.3, 1e-12);
  p_.q[2] = elbow.lower - 0.1;
  add();
  EXPECT_NEAR(result()[Metric::kJointPositionMinMargin], -0.1, 1e-12);
}

TEST_F(Accumulated, EffortIsTheCommandBeforeSaturationAndItsRateThatOfTheTorque) {
  p_.control.commanded[3] = -2.0 * model_.joints[3].limits.effort;
  p_.control.torque[3] = -model_.joints[3].limits.effort;
  add();
  p_.control.torque[3] += 3.0;
  p_.control.torque[5] += 4.0;
  add();
  const Metrics m = result();
  EXPECT_DOUBLE_EQ(m[Metric::kJointEffortMaxRatio], 2.0);
  EXPECT_EQ(m[Metric::kJointEffortSaturatedPeriods], 0.0) << "as the controller says it";
  EXPECT_DOUBLE_EQ(m[Metric::kEffortRateRms], 5.0 / kPeriod) << "the first period has none before it";
  const double effort = model_.joints[3].limits.effort;
  EXPECT_DOUBLE_EQ(m[Metric::kJointEffortRms],
                   std::sqrt(0.5 * (effort * effort + (effort - 3.0) * (effort - 3.0) + 16.0)));
}

TEST_F(Accumulated, AccelerationsAndJerksAreDifferencesOfTheVelocities) {
  p_.control.state = kLeaveSingularity;  // limits count always
  RobotModel with_limit = model_;
  with_limit.joints[2].limits.acceleration = 4.0;
  MetricAccumulator limited(with_limit, 0.1, kPeriod);
  const auto velocity = [&](int joint, double value) {
    p_.qd[joint] = value;
    add();
    limited.add(p_.o);
  };
  velocity(2, 0.3);  // nothing before it
  EXPECT_TRUE(std::isnan(limited.so_far(Metric::kJointAccelerationMax)));
  velocity(2, 0.1);
  EXPECT_DOUBLE_EQ(limited.so_far(Metric::kJointAccelerationMax), 0.2 / kPeriod);
  EXPECT_DOUBLE_EQ(limited.so_far(Metric::kJointAccelerationMaxRatio), 0.2 / kPeriod / 4.0);
  EXPECT_TRUE(std::isnan(limited.so_far(Metric::kJointJerkMax)));
  velocity(4, 0.3);  // faster, and without a limit
  EXPECT_DOUBLE_EQ(limited.so_far(Metric::kJointJerkMax), 0.3 / kPeriod / kPeriod);
  velocity(4, 0.1);  // the acceleration turns round
  const Metrics m = limited.result(1.0);
  EXPECT_DOUBLE_EQ(m[Metric::kJointAccelerationMax], 0.3 / kPeriod);
  EXPECT_DOUBLE_EQ(m[Metric::kJointAccelerationMaxRatio], 0.2 / kPeriod / 4.0);
  EXPECT_NEAR(m[Metric::kJointJerkMax], 0.5 / kPeriod / kPeriod, 1e-12 / kPeriod / kPeriod);
  EXPECT_TRUE(std::isnan(result()[Metric::kJointAccelerationMaxRatio])) << "no joint has a limit";
}

TEST_F(Accumulated, AConstantAccelerationIsWithoutJerk) {
  for (int k = 0; k < 5; ++k) {
    p_.qd[1] = 0.1 * k;
    add();
  }
  // Ten times the rounding error of a velocity, twice divided by the period.
  EXPECT_NEAR(result()[Metric::kJointJerkMax], 0.0, 10.0 * 0.4 * 2.3e-16 / (kPeriod * kPeriod));
}

TEST_F(Accumulated, AJointWithAnEffortLimitOfZeroCountsOnlyUnderTorque) {
  RobotModel weak = model_;
  weak.joints[2].limits.effort = 0.0;
  MetricAccumulator metrics(weak, kThreshold, kPeriod);
  p_.control.commanded[4] = 0.5 * model_.joints[4].limits.effort;
  metrics.add(p_.o);
  EXPECT_DOUBLE_EQ(metrics.so_far(Metric::kJointEffortMaxRatio), 0.5);
  p_.control.commanded[2] = 1.0;
  metrics.add(p_.o);
  EXPECT_TRUE(std::isnan(metrics.so_far(Metric::kJointEffortMaxRatio)));
}

TEST_F(Accumulated, SaturatedPeriodsAreCountedInEveryStateAndOnlyGrow) {
  double counted = 0.0;
  for (const bool saturated : {true, false, true, true, false}) {
    p_.control.saturated = saturated;
    p_.control.state = saturated ? kAvoidObstacles : kFollowTrajectory;
    add();
    counted += saturated ? 1.0 : 0.0;
  }
  EXPECT_EQ(result()[Metric::kJointEffortSaturatedPeriods], counted);
  EXPECT_TRUE(only_worsens(Metric::kJointEffortSaturatedPeriods));
}

TEST_F(Accumulated, TheSmallestClearanceCountsInEveryState) {
  for (const double distance : {0.5, 0.2, 0.4}) {
    p_.control.state = distance == 0.2 ? kAvoidObstacles : kFollowTrajectory;
    p_.o.clearance = distance;
    add();
  }
  EXPECT_EQ(result()[Metric::kObstacleMinClearance], 0.2);
}

TEST_F(Accumulated, GazeAndCompensationCountAlwaysAfterLeaveSingularity) {
  p_.control.state = kLeaveSingularity;
  p_.o.gaze_angle = 3.0;
  p_.o.compensation_error = 100.0;
  add(5);
  p_.control.state = kReturnToTrajectory;
  p_.control.slerping = true;
  p_.o.gaze_angle = kThreshold;  // at the threshold is outside
  p_.o.compensation_error = 4.0;
  add(3);
  p_.control.state = kAvoidObstacles;
  p_.o.gaze_angle = 0.1;
  add(2);
  const Metrics m = result();
  EXPECT_EQ(m[Metric::kGazeMax], kThreshold);
  EXPECT_NEAR(m[Metric::kGazeRms], std::sqrt((3 * kThreshold * kThreshold + 2 * 0.01) / 5.0), 1e-12);
  EXPECT_NEAR(m[Metric::kGazeTimeOutside], 3 * kPeriod, 1e-12);
  EXPECT_DOUBLE_EQ(m[Metric::kCompensationErrorRms], 4.0);
}

TEST_F(Accumulated, TheGazeRateErrorIsBetweenToolAndLineWithoutRoll) {
  // The target passes at 2 m/s in 1 m distance: the line turns at 2 rad/s about -x. Roll about z is free.
  p_.o.target_motion.velocity = Vec3(0.0, 2.0, 0.0);
  p_.o.twist << 0.0, 0.0, 0.0, -2.0, 0.0, 7.0;
  add();
  EXPECT_NEAR(MetricAccumulator(metrics_).result(0.0)[Metric::kGazeRateErrorMax], 0.0, 1e-12);
  p_.o.twist << 0.0, 0.0, 0.0, 0.0, 0.0, 7.0;
  add();
  const Metrics m = result();
  EXPECT_NEAR(m[Metric::kGazeRateErrorMax], 2.0, 1e-12);
  EXPECT_NEAR(m[Metric::kGazeRateErrorRms], 2.0 / std::sqrt(2.0), 1e-12);
}

TEST_F(Accumulated, ReacquisitionRunsFromASwitchOfTheTarget) {
  add(5);
  p_.o.gaze_angle = 1.0;  // lost before any switch: no event
  add(5);
  p_.o.target = 1;
  add(8);
  p_.o.gaze_angle = 0.0;
  add(4);
  EXPECT_NEAR(result()[Metric::kReacquisitionTime], 8 * kPeriod, 1e-12);
}

TEST_F(Accumulated, WhatWasNeverJudgedHasNoValue) {
  p_.control.state = kLeaveSingularity;
  add(5);
  const Metrics m = result();
  EXPECT_EQ(m[Metric::kSamples], 0.0);
  for (const Metric metric :
       {Metric::kPositionXMax, Metric::kPositionRms, Metric::kOrientationMax, Metric::kLinearVelocityRms,
        Metric::kAngularVelocityMax, Metric::kGazeRms, Metric::kGazeTimeOutside, Metric::kGazeRateErrorMax,
        Metric::kReacquisitionTime, Metric::kObstacleMinClearance, Metric::kCompensationErrorRms}) {
    EXPECT_TRUE(std::isnan(m[metric])) << metric_fields()[static_cast<std::size_t>(metric)].name;
  }
  EXPECT_FALSE(std::isnan(m[Metric::kJointPositionMinMargin]));
}

}  // namespace accumulator_test
}  // namespace armtune::internal
