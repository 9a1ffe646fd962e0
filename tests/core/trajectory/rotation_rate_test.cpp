#include "core/trajectory/rotation_rate.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace rotation_rate_test {

using test::derivative;
using test::random_vec3;
using test::WorstError;

/// From far below the series' limit of 0.1 rad through it to the half turn.
constexpr double kAngles[] = {0.0,       1e-9, 1e-4, 0.01, 0.05, 0.09, 0.0999999, 0.1,
                              0.1000001, 0.2,  0.5,  1.0,  2.0,  3.0,  M_PI};
constexpr int kSamples = 20;

MotionPoint<Vec3> random_rotation(std::mt19937& generator, double angle) {
  const Vec3 axis = (random_vec3(generator, 1.0) + Vec3(0.0, 0.0, 1e-3)).normalized();
  const Vec3 velocity = random_vec3(generator, 1.0);
  return {angle * axis, velocity, random_vec3(generator, 1.0)};
}

/// The left Jacobian by its power series, w = sum_k [psi]^k psi' / (k + 1)!, and its derivative term by term:
/// no branch and no quotient that loses digits.
TurnRate by_power_series(const MotionPoint<Vec3>& psi) {
  Vec3 term = psi.velocity;
  Vec3 term_dot = psi.acceleration;
  TurnRate sum{term, term_dot};
  for (int k = 1; k < 40; ++k) {
    term_dot = Vec3(psi.velocity.cross(term) + psi.position.cross(term_dot)) / (k + 1.0);
    term = Vec3(psi.position.cross(term)) / (k + 1.0);
    sum.velocity += term;
    sum.acceleration += term_dot;
  }
  return sum;
}

TEST(RotationRate, IsThePowerSeriesOfTheLeftJacobianOnBothSidesOfItsSwitch) {
  std::mt19937 generator(711);
  // Rounding: the power series' terms grow to pi^3 / 4! before they fall.
  WorstError velocity("w", 2e-15);
  WorstError acceleration("w'", 1e-14);
  for (const double angle : kAngles) {
    for (int sample = 0; sample < kSamples; ++sample) {
      const MotionPoint<Vec3> psi = random_rotation(generator, angle);
      const TurnRate rate = rotation_rate(psi);
      const TurnRate series = by_power_series(psi);
      velocity.compare(rate.velocity, series.velocity, fmt::format("{} rad", angle), 1.0);
      acceleration.compare(rate.acceleration, series.acceleration, fmt::format("{} rad", angle), 1.0);
    }
  }
}

TEST(RotationVectorMotion, IsTheOtherWayRound) {
  std::mt19937 generator(713);
  WorstError worst("psi' and psi''", 1e-12);  // rounding; the inverse grows to pi / 2
  for (const double angle : kAngles) {
    for (int sample = 0; sample < kSamples; ++sample) {
      const MotionPoint<Vec3> psi = random_rotation(generator, angle);
      const MotionPoint<Vec3> back = rotation_vector_motion(psi.position, by_power_series(psi));
      worst.compare(back.velocity, psi.velocity, fmt::format("{} rad", angle), 1.0);
      worst.compare(back.acceleration, psi.acceleration, fmt::format("{} rad", angle), 1.0);
      EXPECT_EQ(back.position, psi.position);
    }
  }
}

TEST(RotationRate, IsHowTheExponentialTurns) {
  std::mt19937 generator(712);
  WorstError velocity("w", 1e-11);  // a difference: rounding, 1e-16 / h at h = 1e-3, and h^4 / 30 of w'''''
  WorstError acceleration("w'", 1e-11);
  for (const double angle : kAngles) {
    for (int sample = 0; sample < kSamples; ++sample) {
      const MotionPoint<Vec3> start = random_rotation(generator, angle);
      const auto psi = [&](double t) {
        return MotionPoint<Vec3>{start.position + t * (start.velocity + t * start.acceleration / 2.0),
                                 start.velocity + t * start.acceleration, start.acceleration};
      };
      const auto R = [&](double t) { return Mat3(rotation_exp(psi(t).position).toRotationMatrix()); };
      const Mat3 W = derivative(R) * R(0.0).transpose();
      const Vec3 w = 0.5 * Vec3(W(2, 1) - W(1, 2), W(0, 2) - W(2, 0), W(1, 0) - W(0, 1));
      const auto rate = [&](double t) { return rotation_rate(psi(t)).velocity; };
      velocity.compare(rotation_rate(start).velocity, w, fmt::format("{} rad", angle), 1.0);
      acceleration.compare(rotation_rate(start).acceleration, derivative(rate), fmt::format("{} rad", angle),
                           1.0);
    }
  }
}

TEST(RotationRate, AboutAStandingAxisIsTheRotationVectorsOwn) {
  std::mt19937 generator(713);
  WorstError worst("one axis", 1e-14);  // rounding
  for (int sample = 0; sample < kSamples; ++sample) {
    const Vec3 axis = random_vec3(generator, 1.0);
    const TurnRate rate = rotation_rate({axis, 0.7 * axis, -0.3 * axis});
    worst.compare(rate.velocity, Vec3(0.7 * axis), "w");
    worst.compare(rate.acceleration, Vec3(-0.3 * axis), "w'");
  }
}

}  // namespace rotation_rate_test
}  // namespace armtune::internal
