#include "core/trajectory/gaze_motion.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace gaze_motion_test {

using test::derivative;
using test::random_vec3;
using test::WorstError;

/// p(t) = p + v t + a t^2/2 + j t^3/6, with its derivatives.
struct Cubic {
  Vec3 p, v, a, j;
  MotionPoint<Vec3> at(double t) const {
    return {p + t * (v + t * (a / 2.0 + t * j / 6.0)), v + t * (a + t * j / 2.0), a + t * j};
  }
};

Cubic random_cubic(std::mt19937& generator, const Vec3& start) {
  const Vec3 v = random_vec3(generator, 0.4);
  const Vec3 a = random_vec3(generator, 0.4);
  return {start, v, a, random_vec3(generator, 0.4)};
}

/// Tool and target that both move, the line between them 0.8 m long and `angle` away from the z axis of a
/// standing frame at t = 0.
struct Sight {
  Mat3 R_0F;
  Cubic tool, target;

  MotionPoint<Vec3> direction(double t) const { return gaze_direction(tool.at(t), target.at(t)); }
  MotionPoint<Vec3> turn(double t) const { return gaze_turn_motion(R_0F, direction(t)); }
  /// The same turn as gaze.hpp has it.
  Vec3 plain_turn(double t) const { return gaze_turn(R_0F, tool.at(t).position, target.at(t).position); }
};

Sight random_sight(std::mt19937& generator, double angle) {
  Sight s;
  s.R_0F = test::random_orientation(generator).toRotationMatrix();
  s.tool = random_cubic(generator, random_vec3(generator, 1.0));
  const double roll = test::random_number(generator, -M_PI, M_PI);
  const Vec3 axis = s.R_0F * Vec3(std::cos(roll), std::sin(roll), 0.0);
  s.target = random_cubic(generator, s.tool.p + 0.8 * (Eigen::AngleAxisd(angle, axis) * s.R_0F.col(2)));
  return s;
}

/// From far below the series' limit, 1 - cos = 1e-4 or 0.01414 rad, through it, to near the half turn.
constexpr double kAngles[] = {0.0,  1e-9, 1e-6, 1e-3, 0.0141, 0.01414, 0.014143, 0.0142,
                              0.02, 0.1,  0.5,  1.0,  M_PI_2, 2.0,     2.5,      3.0};
constexpr int kSamples = 20;

/// Of a difference with h = 1e-3: the ends of a line of r = 0.8 m part at up to 1 m/s, the direction's fifth
/// and sixth derivatives are some 5! / r^5 and 6! / r^6, and h^4 / 30 of that is 1e-10.
constexpr double kDifference = 1e-10;

template <typename Check>
void for_all_sights(unsigned seed, const Check& check) {
  std::mt19937 generator(seed);
  for (const double angle : kAngles) {
    for (int sample = 0; sample < kSamples; ++sample) {
      check(random_sight(generator, angle), fmt::format("{} rad", angle));
    }
  }
}

TEST(GazeDirection, IsAUnitVectorWhoseChangeIsPerpendicularToIt) {
  WorstError unit("|u| = 1", 1e-15);  // rounding
  WorstError across("u u' = 0 and u u'' = -u'^2", 1e-14);
  for_all_sights(701, [&](const Sight& s, const std::string& where) {
    const MotionPoint<Vec3> u = s.direction(0.0);
    unit.compare(u.position.norm(), 1.0, where);
    across.add(std::abs(u.position.dot(u.velocity)), where);
    across.add(std::abs(u.position.dot(u.acceleration) + u.velocity.squaredNorm()), where);
  });
}

TEST(GazeDirection, VelocityAndAccelerationAreTheLinesDerivatives) {
  WorstError first("u'", kDifference);
  WorstError second("u''", kDifference);
  for_all_sights(702, [&](const Sight& s, const std::string& where) {
    const auto line = [&](double t) {
      return Vec3((s.target.at(t).position - s.tool.at(t).position).normalized());
    };
    const auto rate = [&](double t) { return s.direction(t).velocity; };
    const MotionPoint<Vec3> u = s.direction(0.0);
    first.compare(u.velocity, derivative(line), where, 1.0);
    second.compare(u.acceleration, derivative(rate), where, 1.0);
  });
}

TEST(GazeDirection, OfATargetInTheToolIsZeroAndSoIsTheTurn) {
  const MotionPoint<Vec3> at{Vec3(0.3, -0.2, 0.5), Vec3::UnitX(), Vec3::UnitY()};
  const MotionPoint<Vec3> u = gaze_direction(at, {at.position, Vec3::UnitZ(), Vec3::UnitX()});
  const MotionPoint<Vec3> turn = gaze_turn_motion(Mat3::Identity(), u);
  for (const Vec3* zero :
       {&u.position, &u.velocity, &u.acceleration, &turn.position, &turn.velocity, &turn.acceleration}) {
    EXPECT_EQ(*zero, Vec3(0.0, 0.0, 0.0));
  }
}

TEST(DirectionRate, TurnsTheDirectionAsItMovesWithoutRoll) {
  WorstError turns("w x u = u'", 1e-14);  // rounding
  WorstError roll("w u = 0", 1e-15);
  WorstError line("the rate of the line", 1e-14);
  for_all_sights(703, [&](const Sight& s, const std::string& where) {
    const MotionPoint<Vec3> u = s.direction(0.0);
    const Vec3 w = direction_rate(u).velocity;
    turns.compare(Vec3(w.cross(u.position)), u.velocity, where, 1.0);
    roll.add(std::abs(w.dot(u.position)), where);
    line.compare(w, gaze_line_rate(s.tool.p, s.tool.v, s.target.p, s.target.v), where, 1.0);
  });
}

TEST(DirectionRate, AccelerationIsTheDerivativeOfTheVelocity) {
  WorstError worst("w'", kDifference);
  for_all_sights(704, [&](const Sight& s, const std::string& where) {
    const auto w = [&](double t) { return direction_rate(s.direction(t)).velocity; };
    worst.compare(direction_rate(s.direction(0.0)).acceleration, derivative(w), where, 1.0);
  });
}

TEST(GazeTurnMotion, IsTheGazeTurn) {
  WorstError worst("phi", 1e-13);  // rounding, which 1 / sin multiplies by 7 at 3 rad
  for_all_sights(705, [&](const Sight& s, const std::string& where) {
    worst.compare(s.turn(0.0).position, s.plain_turn(0.0), where, 1e-3);
  });
}

TEST(GazeTurnMotion, VelocityAndAccelerationAreItsDerivatives) {
  // Near the half turn phi is bent as 1 / sin(angle): (7 / 0.8)^5 h^4 / 30 = 2e-9, and nine times that for
  // one derivative more.
  WorstError first("phi'", 1e-8);
  WorstError second("phi''", 1e-7);
  WorstError first_near("phi' below pi/2", kDifference);
  WorstError second_near("phi'' below pi/2", kDifference);
  for_all_sights(706, [&](const Sight& s, const std::string& where) {
    const MotionPoint<Vec3> phi = s.turn(0.0);
    const auto turn = [&](double t) { return s.plain_turn(t); };
    const auto rate = [&](double t) { return s.turn(t).velocity; };
    const bool near = phi.position.norm() < M_PI_2;
    (near ? first_near : first).compare(phi.velocity, derivative(turn), where, 1.0);
    (near ? second_near : second).compare(phi.acceleration, derivative(rate), where, 1.0);
  });
}

TEST(GazeTurnMotion, SeriesAndClosedFormAgreeWhereOneTakesOverFromTheOther) {
  std::mt19937 generator(707);
  const double limit = std::acos(1.0 - 1e-4);
  // The two angles differ by 1e-9 rad; the closed form's second derivative has lost eight digits of a term
  // that is 1e-6 of the whole.
  WorstError worst("across the limit", 1e-8);
  for (int sample = 0; sample < 100; ++sample) {
    const std::mt19937 same = generator;
    const Sight below = random_sight(generator, limit - 5e-10);
    generator = same;
    const Sight above = random_sight(generator, limit + 5e-10);
    ASSERT_GT(below.R_0F.col(2).dot(below.direction(0.0).position), 1.0 - 1e-4);
    ASSERT_LT(above.R_0F.col(2).dot(above.direction(0.0).position), 1.0 - 1e-4);
    const MotionPoint<Vec3> a = below.turn(0.0);
    const MotionPoint<Vec3> b = above.turn(0.0);
    worst.compare(a.position, b.position, "phi", 1.0);
    worst.compare(a.velocity, b.velocity, "phi'", 1.0);
    worst.compare(a.acceleration, b.acceleration, "phi''", 1.0);
  }
}

TEST(GazeTurnMotion, StraightBehindIsAHalfTurnAboutXAtRest) {
  const MotionPoint<Vec3> phi =
      gaze_turn_motion(Mat3::Identity(), {-Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitY()});
  EXPECT_EQ(phi.position, Vec3(M_PI, 0.0, 0.0));
  EXPECT_EQ(phi.velocity, Vec3(0.0, 0.0, 0.0));
  EXPECT_EQ(phi.acceleration, Vec3(0.0, 0.0, 0.0));
}

}  // namespace gaze_motion_test
}  // namespace armtune::internal
