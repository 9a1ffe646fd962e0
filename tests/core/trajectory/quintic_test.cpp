#include "core/trajectory/quintic.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace quintic_test {

using test::derivative;
using test::random_number;
using test::random_vec3;
using test::WorstError;

constexpr int kSamples = 50;

MotionPoint<double> random_scalar_motion(std::mt19937& g) {
  return {random_number(g, -2, 2), random_number(g, -2, 2), random_number(g, -2, 2)};
}
MotionPoint<Vec3> random_point_motion(std::mt19937& g) {
  return {random_vec3(g, 2), random_vec3(g, 2), random_vec3(g, 2)};
}

/// Position, velocity and acceleration of two motions, with sizes of 1 as the unit.
template <typename V>
void compare(WorstError& worst, const MotionPoint<V>& a, const MotionPoint<V>& b, const char* where) {
  worst.compare(a.position, b.position, where, 1.0);
  worst.compare(a.velocity, b.velocity, where, 1.0);
  worst.compare(a.acceleration, b.acceleration, where, 1.0);
}

TEST(Quintic, MeetsPositionVelocityAndAccelerationAtBothEnds) {
  std::mt19937 generator(401);
  // Coefficients grow with 1/T^3 to 1/T^5 and cancel in the acceleration at the end: 1e-16 * 240 / T^2.
  WorstError worst("boundary", 1e-10);
  for (int sample = 0; sample < kSamples; ++sample) {
    const double duration = random_number(generator, 0.05, 8.0);
    const auto a = random_scalar_motion(generator);
    const auto b = random_scalar_motion(generator);
    const Quintic<double> scalar(a, b, duration);
    compare(worst, scalar.at(0.0), a, "scalar start");
    compare(worst, scalar.at(duration), b, "scalar end");
    const auto p = random_point_motion(generator);
    const auto q = random_point_motion(generator);
    const Quintic<Vec3> point(p, q, duration);
    compare(worst, point.at(0.0), p, "point start");
    compare(worst, point.at(duration), q, "point end");
    EXPECT_EQ(point.duration(), duration);
  }
}

TEST(Quintic, VelocityAndAccelerationAreTheDerivatives) {
  std::mt19937 generator(402);
  // The five-point difference is exact up to degree 4, and errs by 4 h^4 c5 = 4e-12 * 24 / T^5 of a quintic.
  WorstError worst("derivative", 3e-9);
  for (int sample = 0; sample < kSamples; ++sample) {
    const double duration = random_number(generator, 0.5, 8.0);
    const Quintic<Vec3> path(random_point_motion(generator), random_point_motion(generator), duration);
    const double t = random_number(generator, 0.1, 0.9) * duration;
    const auto position = [&](double s) { return Vec3(path.at(t + s).position); };
    const auto velocity = [&](double s) { return Vec3(path.at(t + s).velocity); };
    worst.compare(path.at(t).velocity, derivative(position), "velocity", 1.0);
    worst.compare(path.at(t).acceleration, derivative(velocity), "acceleration", 1.0);
  }
}

TEST(Quintic, StaysAtItsEndsOutsideItsDuration) {
  std::mt19937 generator(403);
  const Quintic<Vec3> path(random_point_motion(generator), random_point_motion(generator), 1.5);
  for (const auto& [outside, end] : {std::pair(-0.1, 0.0), std::pair(1.6, 1.5), std::pair(1e9, 1.5)}) {
    EXPECT_EQ(path.at(outside).position, path.at(end).position);
    EXPECT_EQ(path.at(outside).velocity, path.at(end).velocity);
    EXPECT_EQ(path.at(outside).acceleration, path.at(end).acceleration);
  }
}

TEST(RestToRest, RisesMonotonicallyAndIsSymmetricAboutItsMiddle) {
  const Quintic<double> s = rest_to_rest(0.2, 1.0, 2.0);
  WorstError symmetry("symmetry", 1e-14);  // rounding
  double last = 0.2;
  for (int step = 1; step < 100; ++step) {
    const double t = 0.02 * step;
    EXPECT_GT(s.at(t).position, last);
    EXPECT_GT(s.at(t).velocity, 0.0);
    last = s.at(t).position;
    symmetry.compare(s.at(1.0 + t).position - 0.6, 0.6 - s.at(1.0 - t).position, "position", 1.0);
  }
  // 10 s^3 - 15 s^4 + 6 s^5 at a quarter, by hand: 53/512.
  EXPECT_NEAR(s.at(0.5).position, 0.2 + 0.8 * 53.0 / 512.0, 1e-15);
}

}  // namespace quintic_test
}  // namespace armtune::internal
