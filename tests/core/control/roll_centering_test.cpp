#include "core/control/roll_centering.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/support/arms.hpp"
#include "tests/core/support/controller_rig.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace roll_centering_test {

constexpr double kPeriod = 0.002;
constexpr double kGain = 0.2;

JointLimits last_limits(const RobotModel& arm) {
  return arm.joints.back().limits;
}

JointVector with_last(const RobotModel& arm, double last) {
  JointVector q = JointVector::Zero(arm.n());
  q[arm.n() - 1] = last;
  return q;
}

TEST(RollCentering, IsOffWhereItCannotKeepItsPromise) {
  const RobotModel arm = test::ur10();
  EXPECT_TRUE(RollCentering(arm, kGain, TaskMask::kPose).is_on());
  EXPECT_FALSE(RollCentering(arm, 0.0, TaskMask::kPose).is_on()) << "no gain";
  EXPECT_FALSE(RollCentering(arm, kGain, TaskMask::kPositionAndAxis).is_on()) << "the roll is no task";
  EXPECT_FALSE(RollCentering(arm, kGain, TaskMask::kPosition).is_on());
  RobotModel endless = arm;
  endless.joints.back().limits.has_position = false;
  EXPECT_FALSE(RollCentering(endless, kGain, TaskMask::kPose).is_on()) << "nothing to stay inside";
  RobotModel askew = arm;
  askew.chain.R_BT = Eigen::AngleAxisd(0.1, Vec3::UnitX()).toRotationMatrix() * askew.chain.R_BT;
  EXPECT_FALSE(RollCentering(askew, kGain, TaskMask::kPose).is_on()) << "a roll would move other joints";
}

/// With the tool's z axis along the joint's and against it.
TEST(RollCentering, BringsTheLastJointToTheMiddleOfItsLimitsWithoutPassingItNorItsShareOfSpeed) {
  RobotModel arm = test::ur10();
  arm.joints.back().limits.lower = -2.0;
  arm.joints.back().limits.upper = 4.0;
  for (const double sign : {1.0, -1.0}) {
    if (sign < 0.0) {
      arm.chain.R_BT = Eigen::AngleAxisd(M_PI, Vec3::UnitX()).toRotationMatrix() * arm.chain.R_BT;
    }
    const double along = arm.chain.R_BT(2, 2) > 0.0 ? 1.0 : -1.0;
    for (const double start : {3.9, -1.9, 1.0}) {
      RollCentering roll(arm, kGain, TaskMask::kPose);
      double q = start;
      double last_rate = 0.0;
      for (int k = 0; k < 60000; ++k) {
        roll.step(with_last(arm, q), kPeriod, false);
        q += kPeriod * along * roll.rate();
        EXPECT_LE(std::abs(roll.rate()), 0.1 * last_limits(arm).velocity);
        // It never jumps: rho' is at most v / T for the T of 1 s.
        EXPECT_LE(std::abs(roll.rate() - last_rate), 2.0 * 0.1 * last_limits(arm).velocity * kPeriod);
        last_rate = roll.rate();
        EXPECT_GE((q - 1.0) * (start - 1.0), -1e-6) << "past the middle at " << k * kPeriod << " s";
      }
      // 120 s at 0.2 /s, of which at most 10 s at full speed.
      EXPECT_NEAR(q, 1.0, 1e-6) << start;
    }
  }
}

/// The desired orientation of a slerp that stands, with the roll: its derivatives are what is added.
TEST(RollCentering, AddsTheDerivativesOfTheOrientationThatItAdds) {
  const RobotModel arm = test::ur10();
  RollCentering roll(arm, kGain, TaskMask::kPose);
  std::mt19937 generator(551);
  const Eigen::Quaterniond start = test::random_orientation(generator);
  const Vec3 w(0.3, -0.2, 0.5);  // the slerp's own, constant, in the base frame
  const auto at = [&](int k) {
    OrientationPoint point{
        Eigen::Quaterniond(Eigen::AngleAxisd(k * kPeriod * w.norm(), w.normalized())) * start, w,
        Vec3::Zero()};
    roll.add_to(point);
    return point;
  };
  // Differences over one period: of first order in it.
  test::WorstError velocity("w", 2e-3);
  test::WorstError acceleration("w'", 2e-2);
  const JointVector q = with_last(arm, 1.5);
  OrientationPoint before = at(0);
  for (int k = 1; k < 2000; ++k) {
    roll.step(q, kPeriod, true);
    const OrientationPoint now = at(k);
    const Eigen::AngleAxisd turn(now.orientation * before.orientation.conjugate());
    velocity.compare(Vec3(turn.angle() / kPeriod * turn.axis()), now.angular_velocity, "w", 0.1);
    if (k > 1) {
      acceleration.compare(Vec3((now.angular_velocity - before.angular_velocity) / kPeriod),
                           now.angular_acceleration, "w'", 0.1);
    }
    before = now;
  }
  EXPECT_GT(std::abs(roll.rate()), 0.05) << "or the roll would be no part of it";
}

TEST(RollCentering, KeepsWhereTheToolLooks) {
  const RobotModel arm = test::ur10();
  RollCentering roll(arm, kGain, TaskMask::kPose);
  std::mt19937 generator(552);
  OrientationPoint point{test::random_orientation(generator), Vec3::Zero(), Vec3::Zero()};
  const Vec3 z = point.orientation * Vec3::UnitZ();
  for (int k = 0; k < 500; ++k) roll.step(with_last(arm, -2.0), kPeriod, true);
  roll.add_to(point);
  EXPECT_LT((point.orientation * Vec3::UnitZ() - z).norm(), 1e-14);
  EXPECT_LT((point.angular_velocity - roll.rate() * z).norm(), 1e-14);
}

/// A whole controller with a kinematic arm that goes where it is told: the circle makes the roll drift.
TEST(RollCentering, KeepsTheLastJointInsideItsLimitsWhileTheToolGoesRound) {
  for (const double gain : {0.0, 0.2}) {
    test::Rig rig;
    rig.period = 0.01;
    rig.gains.roll_centering_gain = gain;
    rig.gains.gaze_feedforward = true;
    rig.gains.slerpAngularErrorThreshold = 1.0;
    rig.path.frequency = 1.5;
    rig.path.terms = {{1, Vec3(0.12, 0, 0), Vec3(0, 0.12, 0)}};
    const std::unique_ptr<Controller> controller = rig.controller();
    JointState state = rig.goal();
    double farthest = 0.0;
    double off = 0.0;
    for (int k = 0; k < 30000; ++k) {  // 300 s
      const ControlOutput& out = controller->update(state, rig.scene(), k * rig.period);
      state.qd = out.reference.velocity;
      state.q += rig.period * state.qd;
      farthest = std::max(farthest, std::abs(state.q[5]));
      if (k > 1000) off = std::max(off, out.gaze_turn.norm());
    }
    if (gain > 0.0) {
      EXPECT_LT(farthest, 1.0);
      EXPECT_LT(off, 0.01) << "rad: the gaze stays on its target";
    } else {
      EXPECT_GT(farthest, 2.0) << "or there would be nothing to control";
    }
  }
}

}  // namespace roll_centering_test
}  // namespace armtune::internal
