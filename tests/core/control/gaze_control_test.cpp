#include "core/control/gaze_control.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/trajectory/gaze_motion.hpp"
#include "core/trajectory/path.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/sight.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace gaze_control_test {

using test::gains_for_gaze;
using test::Sight;
using test::sight;
using test::WorstError;

constexpr double kRounding = 1e-12;

/// With tool and target at rest.
GazeControl::Output update(GazeControl& control, const Gains& gains, const Sight& s, double time) {
  return control.update(gains, s.poses.R_0T, s.Q_0T, {s.poses.p_0T, Vec3::Zero(), Vec3::Zero()},
                        {{s.p_0G, Vec3::Zero(), Vec3::Zero()}}, time);
}

/// s = 10 x^3 - 15 x^4 + 6 x^5 between `from` and 1, with its derivatives: the textbook's polynomial.
MotionPoint<double> rest_to_one(double from, double duration, double t) {
  const double x = t / duration;
  const double rise = 1.0 - from;
  return {from + rise * (10.0 * std::pow(x, 3) - 15.0 * std::pow(x, 4) + 6.0 * std::pow(x, 5)),
          rise * (30.0 * x * x - 60.0 * std::pow(x, 3) + 30.0 * std::pow(x, 4)) / duration,
          rise * (60.0 * x - 180.0 * x * x + 120.0 * std::pow(x, 3)) / (duration * duration)};
}

void compare(WorstError& worst, const OrientationPoint& a, const OrientationPoint& b, const char* where) {
  worst.compare(a.orientation.toRotationMatrix(), b.orientation.toRotationMatrix(), where);
  worst.compare(a.angular_velocity, b.angular_velocity, where, 1.0);
  worst.compare(a.angular_acceleration, b.angular_acceleration, where, 1.0);
}

OrientationPoint turned(const Eigen::Quaterniond& from, const Vec3& turn, const MotionPoint<double>& s) {
  const Eigen::AngleAxisd part(s.position * turn.norm(), turn.normalized());
  return {part * from, s.velocity * turn, s.acceleration * turn};
}

TEST(GazeControl, PointsAtTheTargetAtOnceBelowTheThreshold) {
  std::mt19937 generator(551);
  WorstError worst("z axis", kRounding);
  for (const double angle : {0.0, 0.01, 0.149}) {
    const Sight s = sight(generator, angle);
    GazeControl control;
    const auto out = update(control, gains_for_gaze(), s, 3.0);
    EXPECT_FALSE(out.slerping);
    worst.compare(Vec3(out.desired.orientation * Vec3::UnitZ()), Vec3((s.p_0G - s.poses.p_0T).normalized()),
                  "below");
    EXPECT_TRUE(out.desired.angular_velocity.isZero(0.0));
    EXPECT_TRUE(out.desired.angular_acceleration.isZero(0.0));
  }
}

TEST(GazeControl, SlerpsAboveTheThresholdFromTheFrozenStartForTheGainTimesTheAngle) {
  std::mt19937 generator(552);
  WorstError worst("slerp", kRounding);
  for (const double angle : {0.151, 0.5, 2.0, 3.0}) {
    Sight s = sight(generator, angle);
    const Vec3 turn = gaze_turn(s.poses.R_0T, s.poses.p_0T, s.p_0G);
    const Eigen::Quaterniond Q_start = s.Q_0T;
    const double duration = 2.5 * angle;
    GazeControl control;
    for (int step = 0; step < 100; ++step) {
      const double t = duration * step / 100.0;
      const auto out = update(control, gains_for_gaze(), s, 3.0 + t);
      ASSERT_TRUE(out.slerping);
      compare(worst, out.desired, turned(Q_start, turn, rest_to_one(0.0, duration, t)), "turn");
      // The tool itself does something else; the slerp goes on from where it started.
      s.Q_0T = Eigen::AngleAxisd(0.01, s.poses.R_0T.col(0)) * s.Q_0T;
      s.poses.R_0T = s.Q_0T.toRotationMatrix();
    }
  }
}

TEST(GazeControl, EndsItsSlerpAtTheGoalAndTracksFromThere) {
  std::mt19937 generator(553);
  Sight s = sight(generator, 1.0);
  GazeControl control;
  const Gains gains = gains_for_gaze();
  EXPECT_TRUE(update(control, gains, s, 0.0).slerping);
  const auto last = update(control, gains, s, 2.5 - 1e-6);
  EXPECT_TRUE(last.slerping);
  EXPECT_LT(gaze_angle(last.desired.orientation.toRotationMatrix(), s.poses.p_0T, s.p_0G), 1e-6);
  s.Q_0T = last.desired.orientation;
  s.poses.R_0T = s.Q_0T.toRotationMatrix();
  EXPECT_FALSE(update(control, gains, s, 2.5 + 1e-6).slerping);
}

TEST(GazeControl, StartsAnotherSlerpIfTheToolHasNotArrived) {
  std::mt19937 generator(554);
  const Sight s = sight(generator, 1.0);
  GazeControl control;
  const Gains gains = gains_for_gaze();
  update(control, gains, s, 0.0);
  const auto out = update(control, gains, s, 2.6);
  EXPECT_TRUE(out.slerping);
  EXPECT_LT(out.desired.orientation.angularDistance(s.Q_0T), 1e-7);
}

TEST(GazeControl, FollowsTargetAndToolThatMoveDuringTheSlerp) {
  std::mt19937 generator(555);
  WorstError worst("moving goal", kRounding);
  Sight s = sight(generator, 1.2);
  const Mat3 R_start = s.poses.R_0T;
  const Eigen::Quaterniond Q_start = s.Q_0T;
  GazeControl control;
  const double duration = 2.5 * 1.2;
  for (const double t : {0.0, 0.5, 1.5, 2.5, duration * (1.0 - 1e-12)}) {
    const auto out = update(control, gains_for_gaze(), s, t);
    ASSERT_TRUE(out.slerping);
    const Vec3 turn = gaze_turn(R_start, s.poses.p_0T, s.p_0G);
    compare(worst, out.desired, turned(Q_start, turn, rest_to_one(0.0, duration, t)), "moved");
    s.p_0G += Vec3(0.02, -0.03, 0.04);
    s.poses.p_0T += Vec3(-0.01, 0.02, 0.02);
  }
}

TEST(GazeControl, InCurrentModeSlerpsFromTheMeasuredOrientationAheadOfIt) {
  std::mt19937 generator(556);
  WorstError worst("released code", kRounding);
  Gains gains = gains_for_gaze();
  gains.slerp_reference = SlerpReference::kCurrent;
  gains.slerp_start = 0.2;
  Sight s = sight(generator, 1.0);
  GazeControl control;
  for (int step = 0; step < 50; ++step) {
    const double t = 2.5 * step / 50.0;
    const auto out = update(control, gains, s, t);
    ASSERT_TRUE(out.slerping);
    const Vec3 turn = gaze_turn(s.poses.R_0T, s.poses.p_0T, s.p_0G);
    compare(worst, out.desired, turned(s.Q_0T, turn, rest_to_one(0.2, 2.5, t)), "current");
    s.Q_0T = Eigen::AngleAxisd(0.01, s.poses.R_0T.col(0)) * s.Q_0T;
    s.poses.R_0T = s.Q_0T.toRotationMatrix();
  }
}

TEST(GazeControl, BeginsASlerpAtItsOwnAngleWhereOneIsGiven) {
  std::mt19937 generator(560);
  Gains gains = gains_for_gaze();
  for (const double start : {0.0, 0.1}) {
    gains.slerp_start_angle = start;
    for (const double angle : {0.099, 0.101, 0.149, 0.151}) {
      GazeControl control;
      const bool slerps = update(control, gains, sight(generator, angle), 0.0).slerping;
      EXPECT_EQ(slerps, angle >= (start > 0.0 ? start : 0.15)) << start << " " << angle;
    }
  }
}

TEST(GazeControl, NeverSlerpsForLessThanATwentiethOfASecond) {
  std::mt19937 generator(557);
  Gains gains = gains_for_gaze();
  gains.slerpDurationErrorGain = 0.01;
  const Sight s = sight(generator, 1.0);
  GazeControl control;
  update(control, gains, s, 0.0);
  const auto out = update(control, gains, s, 0.025);
  // Half way at half of 0.05 s; by 0.01 s the slerp would be over and the next one at its start.
  EXPECT_NEAR(out.desired.orientation.angularDistance(s.Q_0T), 0.5, 1e-7);
}

TEST(GazeControl, StretchesASlerpThatTheJointsCannotFollow) {
  const RobotModel arm = test::ur10();
  JointVector q(6);
  q << 0.3, -1.5, -1.5, -1.5, 1.5, 0.0;
  const Poses poses = test::poses_at(arm.chain, q);
  const Jacobian J = test::tool_jacobian_at(arm.chain, q);
  TaskInverse inverse;
  inverse.compute(J, {0.0, 0.05});
  const Vec3 turn = poses.R_0T.col(0);  // of 1 rad
  Vec6 displacement;
  displacement << Vec3::Zero(), turn;
  const JointVector way = J.fullPivLu().solve(displacement);
  const Vec3 p_0G = poses.p_0T + 0.5 * (Eigen::AngleAxisd(1.0, turn) * poses.R_0T.col(2));
  for (const double start : {0.0, 0.2}) {
    // Bounds that let the way take 8 s, more than the 2.5 s of the gain, and 1 s, less than it.
    for (const double seconds : {8.0, 1.0}) {
      const JointVector bound =
          JointVector::Constant(6, (1.0 - start) * 15.0 / 8.0 * way.cwiseAbs().maxCoeff() / seconds);
      Gains gains = gains_for_gaze();
      gains.slerp_start = start;
      GazeControl control;
      const auto at = [&](double time) {
        return control.update(
            gains, poses.R_0T, Eigen::Quaterniond(poses.R_0T), {poses.p_0T, Vec3::Zero(), Vec3::Zero()},
            {{p_0G, Vec3::Zero(), Vec3::Zero()}}, time,
            GazeControl::SpeedBound{[&]() -> const TaskInverse& { return inverse; }, bound});
      };
      at(0.0);
      const double duration = std::max(seconds, 2.5);
      const double middle = at(0.5 * duration).desired.angular_velocity.norm();
      EXPECT_NEAR(middle, (1.0 - start) * 15.0 / 8.0 / duration, 1e-9);  // its peak
      EXPECT_TRUE(at(duration - 1e-6).slerping);
    }
  }
}

}  // namespace gaze_control_test
}  // namespace armtune::internal
