// A gaze that turns with the line to a target that moves.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/control/gaze_control.hpp"
#include "core/trajectory/gaze_motion.hpp"
#include "core/trajectory/path.hpp"
#include "tests/core/support/sight.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace gaze_feedforward_test {

using test::gains_for_gaze;
using test::random_vec3;
using test::Sight;
using test::sight;
using test::WorstError;

/// How a desired orientation turns at t, from differences of it and of its own rate.
struct Differences {
  Vec3 velocity, acceleration;
};

template <typename Turn>
Differences differences(const Turn& turn, double t) {
  const auto R = [&](double h) { return Mat3(turn.desired(t + h).orientation.toRotationMatrix()); };
  const auto rate = [&](double h) { return turn.desired(t + h).angular_velocity; };
  const Mat3 W = test::derivative(R) * R(0.0).transpose();
  return {0.5 * Vec3(W(2, 1) - W(1, 2), W(0, 2) - W(2, 0), W(1, 0) - W(0, 1)), test::derivative(rate)};
}

/// Tool and target that move, and a slerp between them that began at t = 0.
struct MovingSlerp {
  Path tool, target;
  Mat3 R_0T;
  Eigen::Quaterniond Q_0T;
  GazeControl control;
  Gains gains = gains_for_gaze();
  double duration = 0.0;

  MovingSlerp(std::mt19937& generator, bool feedforward) {
    const Sight s = sight(generator, 1.2);
    R_0T = s.poses.R_0T;
    Q_0T = s.Q_0T;
    tool = {s.poses.p_0T, 0.6, 0.0, {{1, Vec3::Zero(), Vec3(0.1, 0.05, -0.1)}}};
    target = {s.p_0G, 0.7, 0.0, {{1, Vec3::Zero(), Vec3(-0.1, 0.1, 0.05)}}};
    gains.gaze_feedforward = feedforward;
    duration = gains.slerpDurationErrorGain * s.angle;
    EXPECT_TRUE(at(0.0, control).slerping);
  }
  /// The output at t of a controller in this state.
  GazeControl::Output at(double t, GazeControl& state) const {
    return state.update(gains, R_0T, Q_0T, tool.at(t), {target.at(t)}, t);
  }
  OrientationPoint desired(double t) const {
    GazeControl state = control;
    return at(t, state).desired;
  }
};

TEST(GazeControl, WithFeedForwardASlerpsReferenceTurnsAsItsOrientationDoes) {
  std::mt19937 generator(558);
  WorstError velocity("wd", 1e-10);  // a difference at h = 1e-3 of turns of some 1 rad/s
  WorstError acceleration("wd'", 1e-9);
  double published = 0.0;
  for (int sample = 0; sample < 20; ++sample) {
    const std::mt19937 same = generator;
    const MovingSlerp slerp(generator, true);
    generator = same;
    const MovingSlerp without(generator, false);
    const double t = slerp.duration * test::random_number(generator, 0.1, 0.9);
    const Differences d = differences(slerp, t);
    velocity.compare(slerp.desired(t).angular_velocity, d.velocity, "random", 1.0);
    acceleration.compare(slerp.desired(t).angular_acceleration, d.acceleration, "random", 1.0);
    EXPECT_EQ(slerp.desired(t).orientation.coeffs(), without.desired(t).orientation.coeffs());
    published = std::max(published, (without.desired(t).angular_velocity - d.velocity).norm());
  }
  EXPECT_GT(published, 0.05) << "the published one leaves the goal's motion out";
}

TEST(GazeControl, WithFeedForwardASlerpEndsWithTheZAxisOnTheLineAndTurningWithIt) {
  std::mt19937 generator(559);
  WorstError worst("u and u'", 1e-10);  // the last 1e-12 of the slerp
  for (int sample = 0; sample < 20; ++sample) {
    const MovingSlerp slerp(generator, true);
    const double t = slerp.duration * (1.0 - 1e-12);
    const OrientationPoint end = slerp.desired(t);
    const MotionPoint<Vec3> u = gaze_direction(slerp.tool.at(t), slerp.target.at(t));
    const Vec3 z = end.orientation * Vec3::UnitZ();
    worst.compare(z, u.position, "z");
    worst.compare(Vec3(end.angular_velocity.cross(z)), u.velocity, "w x z", 0.1);
  }
}

/// A gaze that tracks one target until t = 0, where another one takes its place.
struct Switch {
  static constexpr double kPeriod = 0.002;
  static constexpr double kClock = 3.0;  ///< what the controller's clock shows at the switch [s]
  Path tool, before, after;
  Mat3 R_0T;
  Eigen::Quaterniond Q_0T;
  Gains gains = gains_for_gaze();
  GazeControl control;
  OrientationPoint last;  ///< desired in the period before the switch
  double duration = 0.0;

  Switch(std::mt19937& generator, bool feedforward, bool rested = false) {
    const Sight s = sight(generator, 1.2);
    R_0T = s.poses.R_0T;
    Q_0T = s.Q_0T;
    tool = {s.poses.p_0T, 0.6, 0.0, {{1, Vec3::Zero(), Vec3(0.1, 0.05, -0.1)}}};
    after = {s.p_0G, 0.7, 0.0, {{1, Vec3::Zero(), Vec3(-0.1, 0.1, 0.05)}}};
    // On the tool's axis, and moving past it.
    const Vec3 ahead = s.poses.p_0T + 0.8 * Vec3(R_0T.col(2));
    before = {ahead, 0.9, 0.0, {{1, Vec3::Zero(), random_vec3(generator, 0.4)}}};
    gains.gaze_feedforward = feedforward;
    duration = gains.slerpDurationErrorGain * s.angle;
    const auto tracking =
        control.update(gains, R_0T, Q_0T, tool.at(-kPeriod), {before.at(-kPeriod)}, kClock - kPeriod);
    EXPECT_FALSE(tracking.slerping);
    last = tracking.desired;
    if (rested) control.tool_turns(Vec3::Zero());
    EXPECT_TRUE(control.update(gains, R_0T, Q_0T, tool.at(0.0), {after.at(0.0)}, kClock).slerping);
  }
  OrientationPoint desired(double t) const {
    GazeControl state = control;
    return state.update(gains, R_0T, Q_0T, tool.at(t), {after.at(t)}, kClock + t).desired;
  }
};

TEST(GazeControl, WithFeedForwardASlerpBeginsInTheMotionThatTheGazeHad) {
  std::mt19937 generator(571);
  double slowest = HUGE_VAL;
  for (int sample = 0; sample < 20; ++sample) {
    const std::mt19937 same = generator;
    const Switch moving(generator, true);
    const OrientationPoint first = moving.desired(0.0);
    EXPECT_LT((first.angular_velocity - moving.last.angular_velocity).norm(), 1e-12);
    EXPECT_LT((first.angular_acceleration - moving.last.angular_acceleration).norm(), 1e-12);
    EXPECT_LT(first.orientation.angularDistance(moving.Q_0T), 1e-12);
    slowest = std::min(slowest, moving.last.angular_velocity.norm());
    generator = same;
    const Switch rested(generator, true, true);
    EXPECT_EQ(rested.desired(0.0).angular_velocity.norm(), 0.0);
    GazeControl other;  // behind joint tracking, as the tool turned
    const Vec3 turning = random_vec3(generator, 0.5);
    other.tool_turns(turning);
    const auto began = other.update(moving.gains, moving.R_0T, moving.Q_0T, moving.tool.at(0.0),
                                    {moving.after.at(0.0)}, 0.0);
    EXPECT_LT((began.desired.angular_velocity - turning).norm(), 1e-12);
    generator = same;
    const Switch published(generator, false);
    EXPECT_EQ(published.desired(0.0).angular_velocity.norm(), 0.0) << "as published";
  }
  EXPECT_GT(slowest, 1e-3) << "a gaze at rest shows nothing";
}

TEST(GazeControl, ASlerpThatBeginsInMotionTurnsAsItsOrientationDoesAndEndsOnTheLine) {
  std::mt19937 generator(572);
  WorstError velocity("wd", 1e-10);
  WorstError acceleration("wd'", 1e-9);
  WorstError end("u and u'", 1e-10);
  double onward = 0.0;
  for (int sample = 0; sample < 20; ++sample) {
    const std::mt19937 same = generator;
    const Switch moving(generator, true);
    generator = same;
    const Switch rested(generator, true, true);
    const double t = moving.duration * test::random_number(generator, 0.1, 0.9);
    const Differences d = differences(moving, t);
    velocity.compare(moving.desired(t).angular_velocity, d.velocity, "random", 1.0);
    acceleration.compare(moving.desired(t).angular_acceleration, d.acceleration, "random", 1.0);
    onward = std::max(onward, moving.desired(t).orientation.angularDistance(rested.desired(t).orientation));
    const double last = moving.duration * (1.0 - 1e-12);
    const OrientationPoint at_end = moving.desired(last);
    const MotionPoint<Vec3> u = gaze_direction(moving.tool.at(last), moving.after.at(last));
    const Vec3 z = at_end.orientation * Vec3::UnitZ();
    end.compare(z, u.position, "z");
    end.compare(Vec3(at_end.angular_velocity.cross(z)), u.velocity, "w x z", 0.1);
  }
  EXPECT_GT(onward, 1e-3) << "or both are the same";
}

TEST(GazeControl, BelowTheThresholdTheDesiredOrientationTurnsWithTheLineOnlyWithFeedForward) {
  std::mt19937 generator(561);
  Gains gains = gains_for_gaze();
  for (int sample = 0; sample < 10; ++sample) {
    const Sight s = sight(generator, 0.1);
    const MotionPoint<Vec3> tool{s.poses.p_0T, random_vec3(generator, 0.3), random_vec3(generator, 0.3)};
    const MotionPoint<Vec3> target{s.p_0G, random_vec3(generator, 0.3), random_vec3(generator, 0.3)};
    const TurnRate line = direction_rate(gaze_direction(tool, target));
    for (const bool feedforward : {false, true}) {
      gains.gaze_feedforward = feedforward;
      GazeControl control;
      const auto out = control.update(gains, s.poses.R_0T, s.Q_0T, tool, {target}, 0.0);
      EXPECT_FALSE(out.slerping);
      EXPECT_EQ(out.desired.angular_velocity, feedforward ? line.velocity : Vec3(0.0, 0.0, 0.0));
      EXPECT_EQ(out.desired.angular_acceleration, feedforward ? line.acceleration : Vec3(0.0, 0.0, 0.0));
    }
  }
}

}  // namespace gaze_feedforward_test
}  // namespace armtune::internal
