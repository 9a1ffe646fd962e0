#include "core/trajectory/motion_filter.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace motion_filter_test {

using test::WorstError;

constexpr double kPeriod = 0.002;

MotionPoint<Vec3> accelerated(double t) {
  const Vec3 p(0.3, -0.2, 0.1), v(0.5, 0.1, -0.4), a(-0.3, 0.6, 0.2);
  return {p + t * (v + 0.5 * t * a), v + t * a, a};
}

TEST(MotionFilter, FollowsAPointOfConstantAccelerationWithoutLag) {
  WorstError worst("after a second", 1e-6);  // 30 time constants of 15 rad/s, and rounding / (bandwidth dt)^3
  MotionFilter filter(30.0, kPeriod);
  MotionPoint<Vec3> estimate;
  double t = 0.0;
  for (int k = 0; k <= 1000; ++k) estimate = filter.update(accelerated(t = k * kPeriod).position);
  worst.compare(estimate.position, accelerated(t).position, "position", 1.0);
  worst.compare(estimate.velocity, accelerated(t).velocity, "velocity", 1.0);
  worst.compare(estimate.acceleration, accelerated(t).acceleration, "acceleration", 1.0);
}

TEST(MotionFilter, BeginsAtRestAtTheFirstSample) {
  MotionFilter filter(15.0, kPeriod);
  const MotionPoint<Vec3> estimate = filter.update(Vec3(1.0, 2.0, 3.0));
  EXPECT_EQ(estimate.position, Vec3(1.0, 2.0, 3.0));
  EXPECT_EQ(estimate.velocity, Vec3::Zero());
  EXPECT_EQ(estimate.acceleration, Vec3::Zero());
}

TEST(MotionFilter, LetsAsMuchNoiseThroughAsTheTextbookSays) {
  // Brookner's variance reduction factors of the prediction for the next sample; here the sums of the squared
  // impulse responses.
  for (const double bandwidth : {5.0, 15.0, 60.0}) {
    const double b = std::exp(-bandwidth * kPeriod);
    const double fifth = std::pow(1.0 + b, 5);
    const Vec3 expected((1 - b) / fifth * (19 + 24 * b + 16 * b * b + 6 * b * b * b + b * b * b * b),
                        0.5 * std::pow(1 - b, 3) / fifth * (49 + 50 * b + 13 * b * b) / std::pow(kPeriod, 2),
                        6.0 * std::pow(1 - b, 5) / fifth / std::pow(kPeriod, 4));
    MotionFilter filter(bandwidth, kPeriod);
    filter.update(Vec3::Zero());
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < 20000; ++k) {
      const MotionPoint<Vec3>& response = filter.update(k == 0 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::Zero()));
      const double a = response.acceleration.x();
      const double v = response.velocity.x() + kPeriod * a;
      const double p = response.position.x() + kPeriod * (v - 0.5 * kPeriod * a);
      sum += Vec3(p, v, a).cwiseAbs2();
    }
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(sum[i] / expected[i], 1.0, 1e-9) << bandwidth << " " << i;
  }
}

}  // namespace motion_filter_test
}  // namespace armtune::internal
