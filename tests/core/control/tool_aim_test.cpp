#include "core/control/tool_aim.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "core/control/gaze_control.hpp"
#include "tests/core/support/sight.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace tool_aim_test {

using test::derivative;
using test::random_vec3;
using test::WorstError;

/// An orientation that turns: Q(t) = exp(a + b t + c t^2) Q0, and a tool that moves meanwhile.
struct Turning {
  explicit Turning(std::mt19937& generator)
      : Q(test::random_orientation(generator)),
        R_0F(test::random_orientation(generator).toRotationMatrix()),
        a(random_vec3(generator, 0.3)),
        b(random_vec3(generator, 1.0)),
        c(random_vec3(generator, 1.0)),
        tool{random_vec3(generator, 1.0), random_vec3(generator, 1.0), random_vec3(generator, 1.0)} {}

  OrientationPoint at(double t) const {
    const MotionPoint<Vec3> psi{a + t * (b + t * c), b + 2.0 * t * c, 2.0 * c};
    const TurnRate rate = rotation_rate(psi);
    return {rotation_exp(psi.position) * Q, rate.velocity, rate.acceleration};
  }

  Eigen::Quaterniond Q;
  Mat3 R_0F;  ///< a frame that stands
  Vec3 a, b, c;
  MotionPoint<Vec3> tool;
};

TEST(ToolAim, OfAnOrientationTheTurnLeadsToIt) {
  std::mt19937 generator(731);
  WorstError worst("orientation", 1e-12);
  for (int sample = 0; sample < 20; ++sample) {
    const Turning turning(generator);
    const OrientationPoint wanted = turning.at(0.0);
    const ToolAim aim{turning.tool, &wanted, false};
    const Vec3 turn = aim.turn(turning.R_0F, turning.tool.position);
    worst.compare(Mat3(rotation_exp(turn).toRotationMatrix() * turning.R_0F),
                  wanted.orientation.toRotationMatrix(), "whole");
    EXPECT_LE(turn.norm(), M_PI);
    EXPECT_EQ(aim.rate(turning.tool).velocity, wanted.angular_velocity);
    EXPECT_EQ(aim.rate(turning.tool).acceleration, wanted.angular_acceleration);
  }
}

TEST(ToolAim, OfAnAxisTheTurnIsTheShortestThatTakesZThere) {
  std::mt19937 generator(732);
  for (int sample = 0; sample < 20; ++sample) {
    const Turning turning(generator);
    const OrientationPoint wanted = turning.at(0.0);
    const ToolAim aim{turning.tool, &wanted, true};
    const Vec3 turn = aim.turn(turning.R_0F, turning.tool.position);
    const Vec3 z = wanted.orientation * Vec3::UnitZ();
    EXPECT_LT((rotation_exp(turn) * turning.R_0F.col(2) - z).norm(), 1e-12);
    EXPECT_NEAR(turn.dot(turning.R_0F.col(2)), 0.0, 1e-12) << "no roll";
    // The axis turns with the orientation: z' = w x z of both.
    const TurnRate rate = aim.rate(turning.tool);
    EXPECT_LT((rate.velocity.cross(z) - wanted.angular_velocity.cross(z)).norm(), 1e-12);
    EXPECT_NEAR(rate.velocity.dot(z), 0.0, 1e-12);
    const auto velocity = [&](double t) {
      const OrientationPoint then = turning.at(t);
      return ToolAim{turning.tool, &then, true}.rate(turning.tool).velocity;
    };
    EXPECT_LT((rate.acceleration - derivative(velocity)).norm(), 1e-8);
  }
}

TEST(ToolAim, TheTurnFromAStandingFrameChangesAsItsDerivativesSay) {
  std::mt19937 generator(733);
  WorstError velocity("phi'", 1e-7);  // differences, of a turn up to 2.8 rad
  WorstError acceleration("phi''", 1e-7);
  for (const bool axis_only : {false, true}) {
    for (int sample = 0; sample < 40; ++sample) {
      const Turning turning(generator);
      Vec3 last = Vec3::Zero();
      const auto motion = [&](double t) {
        const OrientationPoint then = turning.at(t);
        return ToolAim{turning.tool, &then, axis_only}.turn_motion(turning.R_0F, turning.tool, last);
      };
      last = motion(0.0).position;
      const MotionPoint<Vec3> now = motion(0.0);
      if (axis_only && now.position.norm() > 2.8) continue;  // straight behind, it has no derivative
      const std::string where = fmt::format("{} {}", axis_only, sample);
      velocity.compare(now.velocity, derivative([&](double t) { return Vec3(motion(t).position); }), where,
                       1.0);
      acceleration.compare(now.acceleration, derivative([&](double t) { return Vec3(motion(t).velocity); }),
                           where, 1.0);
    }
  }
}

TEST(ToolAim, AGazeIsWhatItWas) {
  std::mt19937 generator(734);
  const test::Sight s = test::sight(generator, 0.7);
  const MotionPoint<Vec3> tool{s.poses.p_0T, random_vec3(generator, 1.0), random_vec3(generator, 1.0)};
  const ToolAim aim{{s.p_0G, random_vec3(generator, 1.0), random_vec3(generator, 1.0)}};
  EXPECT_EQ(aim.turn(s.poses.R_0T, tool.position), gaze_turn(s.poses.R_0T, tool.position, s.p_0G));
  EXPECT_EQ(aim.rate(tool).acceleration, direction_rate(gaze_direction(tool, aim.target)).acceleration);
}

TEST(GazeControl, SlerpsOntoAnOrientationThatTurnsAndThenTurnsWithIt) {
  std::mt19937 generator(735);
  const Turning turning(generator);
  Gains gains = test::gains_for_gaze();
  gains.gaze_feedforward = true;
  gains.slerpDurationErrorGain = 0.2;
  GazeControl control;
  const Eigen::Quaterniond Q_0F(turning.R_0F);
  const MotionPoint<Vec3> tool = turning.tool;
  const auto at = [&](double t, const Eigen::Quaterniond& Q) {
    const OrientationPoint wanted = turning.at(t);
    return control.update(gains, Q.toRotationMatrix(), Q, tool, {tool, &wanted, false}, t);
  };
  const GazeControl::Output first = at(0.0, Q_0F);
  ASSERT_TRUE(first.slerping);
  const double duration = gains.slerpDurationErrorGain * first.turn.norm();
  const OrientationPoint last = at(duration - 1e-9, Q_0F).desired;
  EXPECT_LT(rotation_log(last.orientation * turning.at(duration).orientation.conjugate()).norm(), 1e-6);
  EXPECT_LT((last.angular_velocity - turning.at(duration).angular_velocity).norm(), 1e-5);
  const double later = duration + 0.01;
  const GazeControl::Output on = at(later, turning.at(later).orientation);
  EXPECT_FALSE(on.slerping);
  EXPECT_EQ(on.desired.angular_velocity, turning.at(later).angular_velocity);
  EXPECT_LT(on.turn.norm(), 1e-12);
}

TEST(GazeControl, ASlerpGoesOnPastHalfATurnOfItsGoal) {
  Gains gains = test::gains_for_gaze();
  gains.slerpDurationErrorGain = 2.0;
  const MotionPoint<Vec3> tool{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  for (const bool feedforward : {false, true}) {
    gains.gaze_feedforward = feedforward;
    GazeControl control;
    Eigen::Quaterniond last = Eigen::Quaterniond::Identity();
    // About z from 2.8 rad on at 0.2 rad/s: half a turn is passed after 1.7 s of the slerp's 5.6.
    double farthest = 0.0;
    for (double t = 0.0; t < 5.5; t += 0.002) {
      const double angle = 2.8 + 0.2 * t;
      const OrientationPoint wanted{Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vec3::UnitZ())),
                                    0.2 * Vec3::UnitZ(), Vec3::Zero()};
      const auto out = control.update(gains, Mat3::Identity(), Eigen::Quaterniond::Identity(), tool,
                                      {tool, &wanted, false}, t);
      ASSERT_TRUE(out.slerping) << t;
      const double step = rotation_log(out.desired.orientation * last.conjugate()).norm();
      EXPECT_LT(step, 0.01) << t << ": the peak of the quintic is 15/8 of 3.9 rad in 5.6 s";
      last = out.desired.orientation;
      farthest = angle;
    }
    EXPECT_GT(farthest, 3.8);
    EXPECT_NEAR(rotation_log(last * Eigen::AngleAxisd(-farthest, Vec3::UnitZ())).norm(), 0.0, 0.01);
  }
}

}  // namespace tool_aim_test
}  // namespace armtune::internal
