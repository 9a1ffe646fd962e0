#include "core/trajectory/joint_spline.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "armtune/error.hpp"
#include "core/trajectory/linear_acceleration.hpp"
#include "tests/core/support/refused_at.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace joint_spline_test {

using test::derivative;
using test::random_number;
using test::random_vector;
using test::WorstError;

constexpr int kJoints = 7;

/// Knots at uneven times from 8 s on that lie on one motion: each continues the one before.
JointSpline random_spline(unsigned seed, int knots) {
  std::mt19937 generator(seed);
  std::vector<double> time = {8.0};
  std::vector<MotionPoint<JointVector>> motion = {{random_vector(generator, kJoints, 2.0),
                                                   random_vector(generator, kJoints, 1.0),
                                                   random_vector(generator, kJoints, 3.0)}};
  for (int k = 1; k < knots; ++k) {
    const double h = random_number(generator, 0.02, 0.2);
    time.push_back(time.back() + h);
    motion.push_back(linear_acceleration(motion.back(), random_vector(generator, kJoints, 3.0), h, h));
  }
  return {time, motion};
}

TEST(LinearAcceleration, ReachesItsEndInAStraightLineAndIntegratesIt) {
  std::mt19937 generator(541);
  WorstError worst("derivative", 1e-11);  // cubics are exact in the five-point rule: rounding over its step
  for (int sample = 0; sample < 50; ++sample) {
    const MotionPoint<double> start{random_number(generator, -2, 2), random_number(generator, -2, 2),
                                    random_number(generator, -9, 9)};
    const double end = random_number(generator, -9, 9);
    const double h = random_number(generator, 0.01, 1.0);
    const auto at = [&](double s) { return linear_acceleration(start, end, h, s); };
    EXPECT_EQ(at(0.0).position, start.position);
    EXPECT_EQ(at(0.0).velocity, start.velocity);
    worst.compare(at(0.0).acceleration, start.acceleration, "start", 1.0);
    worst.compare(at(h).acceleration, end, "end", 1.0);
    worst.compare(at(0.5 * h).acceleration, 0.5 * (start.acceleration + end), "middle", 1.0);
    for (const double s : {0.2 * h, 0.7 * h}) {
      worst.compare(derivative([&](double d) { return at(s + d).position; }), at(s).velocity, "velocity",
                    1.0);
      worst.compare(derivative([&](double d) { return at(s + d).velocity; }), at(s).acceleration,
                    "acceleration", 1.0);
    }
  }
}

TEST(JointSpline, PassesThroughItsKnotsWithoutAJump) {
  const JointSpline spline = random_spline(542, 40);
  WorstError worst("knots", 1e-12);   // rounding
  WorstError across("across", 1e-8);  // of 1e-9 s at 3 rad/s and 150 rad/s^2
  for (std::size_t k = 0; k < spline.time().size(); ++k) {
    const double t = spline.time()[k];
    worst.compare(spline.at(t).position, spline.knots()[k].position, "position", 1.0);
    worst.compare(spline.at(t).velocity, spline.knots()[k].velocity, "velocity", 1.0);
    worst.compare(spline.at(t).acceleration, spline.knots()[k].acceleration, "acceleration", 1.0);
    across.compare(spline.at(t - 1e-9).position, spline.at(t + 1e-9).position, "position", 1.0);
    across.compare(spline.at(t - 1e-9).velocity, spline.at(t + 1e-9).velocity, "velocity", 1.0);
  }
}

TEST(JointSpline, BetweenKnotsVelocityAndAccelerationAreTheDerivatives) {
  const JointSpline spline = random_spline(543, 20);
  WorstError worst("derivative", 1e-10);  // rounding of numbers near 8 s over the step of 1e-3 s
  for (std::size_t k = 1; k < spline.time().size(); ++k) {
    const double t = 0.5 * (spline.time()[k - 1] + spline.time()[k]);
    worst.compare(derivative([&](double d) { return spline.at(t + d).position; }), spline.at(t).velocity,
                  "velocity", 1.0);
    worst.compare(derivative([&](double d) { return spline.at(t + d).velocity; }), spline.at(t).acceleration,
                  "acceleration", 1.0);
  }
}

TEST(JointSpline, OutsideItIsHeldAsItBeginsAndEnds) {
  const JointSpline spline = random_spline(544, 5);
  EXPECT_EQ(spline.begin(), spline.time().front());
  EXPECT_EQ(spline.end(), spline.time().back());
  EXPECT_EQ(spline.at(0.0).position, spline.at(spline.begin()).position);
  EXPECT_EQ(spline.at(100.0).position, spline.at(spline.end()).position);
  EXPECT_EQ(spline.at(100.0).velocity, spline.at(spline.end()).velocity);
  EXPECT_EQ(spline.mean_acceleration(100.0, 0.1), spline.at(spline.end()).acceleration);
}

TEST(JointSpline, TheMeanAccelerationHeldForAPeriodTakesTheVelocityToItsEnd) {
  const JointSpline spline = random_spline(545, 20);
  std::mt19937 generator(546);
  WorstError mean("mean", 1e-3);      // of a sum over 2000 midpoints across kinks
  WorstError within("within", 1e-9);  // one knot interval: the middle's acceleration; rounding over 1 ms
  for (int sample = 0; sample < 30; ++sample) {
    const double t = random_number(generator, spline.begin(), spline.end() - 0.3);
    const double dt = random_number(generator, 0.01, 0.3);
    JointVector sum = JointVector::Zero(kJoints);
    for (int i = 0; i < 2000; ++i) sum += spline.at(t + (i + 0.5) * dt / 2000).acceleration / 2000;
    mean.compare(spline.mean_acceleration(t, dt), sum, "sum", 1.0);
  }
  const double t = spline.time()[3] + 1e-3;
  within.compare(spline.mean_acceleration(t, 1e-3), spline.at(t + 0.5e-3).acceleration, "middle", 1.0);
  // What is left of the motion counts alone.
  within.compare(spline.mean_acceleration(spline.end() - 2e-3, 1.0),
                 spline.at(spline.end() - 1e-3).acceleration, "last", 1.0);
}

InputError refusal(const std::vector<double>& time, std::size_t knots) {
  const JointVector zero = JointVector::Zero(2);
  return test::input_error([&] {
    JointSpline(time, std::vector<MotionPoint<JointVector>>(knots, {zero, zero, zero}));
  });
}

TEST(JointSpline, RefusesWhatIsNoMotion) {
  const std::string limit = "as many times as knots, at least 2";
  EXPECT_THAT(refusal({1.0}, 1), test::refused_at({.value = "1", .limit = limit}));
  EXPECT_THAT(refusal({1.0, 2.0}, 3), test::refused_at({.value = "2", .limit = limit}));
  EXPECT_THAT(refusal({1.0, 2.0, 2.0}, 3), test::refused_at({.value = "2", .limit = "above 2"}));
  EXPECT_STREQ(refusal({1.0, 2.0, 2.5}, 3).what(), "nothing was refused");
}

// Trajectory::sample of ros2_controllers with interpolation_method none, at its comparisons of times:
// t in [t_k, t_k+1) gives point k + 1, and from the end on it gives the last point.
TEST(JointSpline, WithoutInterpolationTheNextPointIsTheState) {
  const std::vector<double> time = {2.0, 2.5, 4.0};
  std::vector<MotionPoint<JointVector>> points;
  for (int k = 0; k < 3; ++k)
    points.push_back({JointVector::Constant(2, k), JointVector::Constant(2, 10.0 + k), JointVector::Ones(2)});
  const JointSpline motion(time, points, PointsGive::kVelocities, BetweenPoints::kNextPoint);
  const auto point_at = [&motion](double t) {
    const MotionPoint<JointVector> point = motion.at(t);
    EXPECT_EQ(point.velocity[1], 10.0 + point.position[0]) << "all of one point, at " << t;
    EXPECT_TRUE(point.acceleration.isZero(0.0)) << "not given";
    return point.position[0];
  };
  EXPECT_EQ(point_at(1.9), 0.0) << "the motion has not begun";
  EXPECT_EQ(point_at(2.0), 1.0);
  EXPECT_EQ(point_at(2.4999), 1.0);
  EXPECT_EQ(point_at(2.5), 2.0);
  EXPECT_EQ(point_at(3.9), 2.0);
  EXPECT_EQ(point_at(4.0), 2.0);
  EXPECT_EQ(point_at(9.0), 2.0);
}

}  // namespace joint_spline_test
}  // namespace armtune::internal
