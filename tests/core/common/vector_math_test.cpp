#include "core/common/vector_math.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/common/joint_math.hpp"
#include "core/robot/friction.hpp"

namespace armtune::internal {
namespace vector_math_test {

using vector_math::Double2;

/// Difference in units in the last place of a double near the exact value.
double ulps(double value, long double exact) {
  int exponent = 0;
  std::frexp(static_cast<double>(exact), &exponent);
  return static_cast<double>(std::abs(static_cast<long double>(value) - exact)) /
         std::ldexp(1.0, exponent - 53);
}

struct Worst {
  double sine = 0.0;
  double cosine = 0.0;
};

Worst worst_up_to(double range) {
  std::mt19937_64 generator(11);
  std::uniform_real_distribution<double> draw(-range, range);
  Worst worst;
  for (int i = 0; i < 200000; ++i) {
    const Double2 x = {draw(generator), draw(generator)};
    Double2 s;
    Double2 c;
    vector_math::sine_cosine(x, s, c);
    for (int lane = 0; lane < 2; ++lane) {
      worst.sine = std::max(worst.sine, ulps(s[lane], std::sin(static_cast<long double>(x[lane]))));
      worst.cosine = std::max(worst.cosine, ulps(c[lane], std::cos(static_cast<long double>(x[lane]))));
    }
  }
  return worst;
}

TEST(VectorMath, SineAndCosineAreExactToUnitsInTheLastPlace) {
  for (const auto& [range, limit] : {std::pair{M_PI / 4.0, 1.0}, {10.0, 2.0}, {1000.0, 2.0}, {1e5, 3.0}}) {
    const Worst worst = worst_up_to(range);
    EXPECT_LT(worst.sine, limit) << range;
    EXPECT_LT(worst.cosine, limit) << range;
  }
}

TEST(VectorMath, LanesDoNotSeeEachOther) {
  std::mt19937_64 generator(12);
  std::uniform_real_distribution<double> draw(-7.0, 7.0);
  for (int i = 0; i < 1000; ++i) {
    const double x = draw(generator);
    Double2 s;
    Double2 c;
    vector_math::sine_cosine(Double2{x, draw(generator)}, s, c);
    Double2 s_alone;
    Double2 c_alone;
    vector_math::sine_cosine(Double2{std::nan(""), x}, s_alone, c_alone);
    EXPECT_EQ(s[0], s_alone[1]);
    EXPECT_EQ(c[0], c_alone[1]);
    EXPECT_TRUE(std::isnan(s_alone[0]));
    EXPECT_TRUE(std::isnan(c_alone[0]));
  }
}

TEST(VectorMath, ExponentialIsExactToUnitsInTheLastPlace) {
  std::mt19937_64 generator(13);
  for (const double range : {0.3, 30.0, 700.0}) {
    std::uniform_real_distribution<double> draw(-range, range);
    double worst = 0.0;
    for (int i = 0; i < 200000; ++i) {
      const Double2 x = {draw(generator), draw(generator)};
      const Double2 e = vector_math::exponential(x);
      for (int lane = 0; lane < 2; ++lane) {
        worst = std::max(worst, ulps(e[lane], std::exp(static_cast<long double>(x[lane]))));
      }
    }
    EXPECT_LT(worst, 2.0) << range;
  }
}

TEST(VectorMath, ExponentialEndsSomewhereAndKeepsANaN) {
  const double infinity = std::numeric_limits<double>::infinity();
  const Double2 ends = vector_math::exponential(Double2{-infinity, infinity});
  EXPECT_LT(ends[0], 1e-307);
  EXPECT_GE(ends[0], 0.0);
  EXPECT_GT(ends[1], 1e307);
  const Double2 none = vector_math::exponential(Double2{std::nan(""), 0.0});
  EXPECT_TRUE(std::isnan(none[0]));
  EXPECT_EQ(none[1], 1.0);
}

// Odd and even numbers of joints, and angles that nobody reaches.
TEST(JointMath, IsTheLibrarysOfEveryJoint) {
  std::mt19937_64 generator(14);
  std::uniform_real_distribution<double> draw(-7.0, 7.0);
  for (int n = 1; n <= kMaxJoints; ++n) {
    for (const double factor : {1.0, 1e6}) {
      JointVector x(n);
      for (double& entry : x) entry = factor * draw(generator);
      JointVector s;
      JointVector c;
      sines_and_cosines(x, s, c);
      JointVector directions;
      coulomb_directions(x, directions);
      ASSERT_EQ(s.size(), n);
      ASSERT_EQ(c.size(), n);
      ASSERT_EQ(directions.size(), n);
      for (int i = 0; i < n; ++i) {
        EXPECT_NEAR(s[i], std::sin(x[i]), 3e-16);
        EXPECT_NEAR(c[i], std::cos(x[i]), 3e-16);
        EXPECT_EQ(directions[i], coulomb_direction(x[i]));
      }
    }
  }
}

// Roundings of the exponential, its sum with 1 and the quotient come to 5e-16.
TEST(Friction, ItsDirectionIsTheHyperbolicTangent) {
  for (int i = -2000; i <= 2000; ++i) {
    const double qd = 1e-3 * i;
    EXPECT_NEAR(coulomb_direction(qd), std::tanh(qd / kCoulombVelocity), 5e-16) << qd;
  }
}

}  // namespace vector_math_test
}  // namespace armtune::internal
