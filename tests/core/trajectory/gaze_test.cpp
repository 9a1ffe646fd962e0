#include "core/trajectory/gaze.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace gaze_test {

using test::derivative;
using test::random_vec3;
using test::WorstError;

struct Sight {
  Mat3 R_0T;
  Vec3 p_0T, p_0G;
  Vec3 line() const { return (p_0G - p_0T).normalized(); }
};

Sight random_sight(std::mt19937& generator) {
  const Mat3 R = test::random_orientation(generator).toRotationMatrix();
  const Vec3 p = random_vec3(generator, 1.0);
  return {R, p, random_vec3(generator, 2.0)};
}

TEST(GazeTurn, PointsTheToolsZAxisAtTheTarget) {
  std::mt19937 generator(431);
  WorstError worst("z axis", 1e-13);  // rounding
  for (int sample = 0; sample < 100; ++sample) {
    const Sight s = random_sight(generator);
    const Mat3 turned = rotation_exp(gaze_turn(s.R_0T, s.p_0T, s.p_0G)).toRotationMatrix() * s.R_0T;
    worst.compare(Vec3(turned.col(2)), s.line(), "random");
  }
}

TEST(GazeTurn, LeavesTheRollAboutTheToolsZAxisAlone) {
  std::mt19937 generator(432);
  WorstError worst("roll", 1e-13);  // rounding
  for (int sample = 0; sample < 100; ++sample) {
    const Sight s = random_sight(generator);
    const Vec3 turn = gaze_turn(s.R_0T, s.p_0T, s.p_0G);
    worst.add(std::abs(turn.normalized().dot(s.R_0T.col(2))), "axis to z");
    worst.add(std::abs(turn.normalized().dot(s.line())), "axis to line");
  }
}

TEST(GazeTurn, IsTheShortestOne) {
  std::mt19937 generator(433);
  WorstError worst("angle", 1e-12);  // acos loses digits where the line nears the axis
  for (int sample = 0; sample < 100; ++sample) {
    const Sight s = random_sight(generator);
    worst.compare(gaze_angle(s.R_0T, s.p_0T, s.p_0G), std::acos(s.R_0T.col(2).dot(s.line())), "random");
  }
}

TEST(GazeTurn, IsZeroWhenTheToolPointsAtTheTargetAlready) {
  std::mt19937 generator(434);
  for (int sample = 0; sample < 20; ++sample) {
    const Sight s = random_sight(generator);
    const Vec3 ahead = s.p_0T + 0.7 * s.R_0T.col(2);
    EXPECT_LT(gaze_angle(s.R_0T, s.p_0T, ahead), 1e-15 / 0.7 * 4.0);  // rounding of the target's position
  }
}

TEST(GazeTurn, GoesAboutTheToolsXAxisForATargetStraightBehind) {
  const Vec3 p(0.3, -0.2, 0.5);
  const Vec3 turn = gaze_turn(Mat3::Identity(), p, p - 2.0 * Vec3::UnitZ());
  EXPECT_EQ(turn, Vec3(M_PI, 0.0, 0.0));
  const Vec3 z = rotation_exp(turn) * Vec3::UnitZ();
  EXPECT_LT((z + Vec3::UnitZ()).norm(), 1e-15);
}

TEST(GazeTurn, IsZeroForATargetInTheTool) {
  const Vec3 p(0.3, -0.2, 0.5);
  EXPECT_EQ(gaze_turn(Mat3::Identity(), p, p), Vec3(0.0, 0.0, 0.0));
  EXPECT_EQ(gaze_line_rate(p, Vec3::UnitX(), p, Vec3::Zero()), Vec3(0.0, 0.0, 0.0));
}

TEST(GazeLineRate, IsTheTurnRateOfTheUnitLineWithoutRoll) {
  std::mt19937 generator(435);
  WorstError worst("rate", 1e-9);  // u' is a difference; targets may be as near as 0.1 m: (1/0.1)^5 h^4 / 30
  for (int sample = 0; sample < 100; ++sample) {
    const Sight s = random_sight(generator);
    if ((s.p_0G - s.p_0T).norm() < 0.3) continue;
    const Vec3 v_0T = random_vec3(generator, 1.0);
    const Vec3 v_0G = random_vec3(generator, 1.0);
    const auto u = [&](double t) { return Vec3((s.p_0G + t * v_0G - s.p_0T - t * v_0T).normalized()); };
    const Vec3 w = gaze_line_rate(s.p_0T, v_0T, s.p_0G, v_0G);
    worst.compare(Vec3(w.cross(u(0.0))), derivative(u), "u' = w x u");
    worst.add(std::abs(w.dot(u(0.0))), "roll");
  }
}

}  // namespace gaze_test
}  // namespace armtune::internal
