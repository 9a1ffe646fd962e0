#include "core/trajectory/path.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace path_test {

using test::derivative;
using test::random_number;
using test::random_vec3;
using test::WorstError;

Path random_path(std::mt19937& g) {
  Path path{random_vec3(g, 1.0), random_number(g, 0.1, 2.0), random_number(g, -3.0, 3.0), {}};
  for (const int order : {1, 2, 1, 3, 0}) {
    path.terms.push_back({order, random_vec3(g, 0.5), random_vec3(g, 0.5)});
  }
  return path;
}

/// x = ax + r sin(wt), y = ay + r cos(wt) - r.
Path circle(double ax, double ay, double z, double r, double w) {
  return {Vec3(ax, ay - r, z), w, 0.0, {{1, Vec3(0.0, r, 0.0), Vec3(r, 0.0, 0.0)}}};
}

TEST(Path, IsTheSumOfItsHarmonics) {
  std::mt19937 generator(411);
  WorstError worst("position", 1e-14);  // rounding
  for (int sample = 0; sample < 30; ++sample) {
    const Path path = random_path(generator);
    const double t = random_number(generator, -10.0, 10.0);
    Vec3 p = path.center;
    for (const HarmonicTerm& term : path.terms) {
      const double angle = term.order * (path.frequency * t + path.phase);
      p += term.cosine * std::cos(angle) + term.sine * std::sin(angle);
    }
    worst.compare(path.at(t).position, p, "sum", 1.0);
  }
}

TEST(Path, VelocityAndAccelerationAreTheDerivatives) {
  std::mt19937 generator(412);
  WorstError worst("derivative", 1e-9);  // third harmonic of 2 rad/s: 6^5 h^4 / 30 = 3e-10 at h = 1e-3
  for (int sample = 0; sample < 30; ++sample) {
    const Path path = random_path(generator);
    const double t = random_number(generator, -10.0, 10.0);
    const auto position = [&](double s) { return Vec3(path.at(t + s).position); };
    const auto velocity = [&](double s) { return Vec3(path.at(t + s).velocity); };
    worst.compare(path.at(t).velocity, derivative(position), "velocity", 1.0);
    worst.compare(path.at(t).acceleration, derivative(velocity), "acceleration", 1.0);
  }
}

TEST(Path, JerkIsTheDerivativeOfTheAcceleration) {
  std::mt19937 generator(414);
  WorstError worst("derivative", 1e-8);  // as above, one order on
  for (int sample = 0; sample < 30; ++sample) {
    Path path = random_path(generator);
    const double t = random_number(generator, 0.1, 0.9);
    if (sample % 2 == 0) {
      path.terms.clear();
      const auto knot = [&] {
        return MotionPoint<Vec3>{random_vec3(generator, 1.0), random_vec3(generator, 1.0),
                                 random_vec3(generator, 1.0)};
      };
      path.spline = std::make_shared<const PositionSpline>(
          std::vector<double>{0.0, 2.0}, std::vector<MotionPoint<Vec3>>{knot(), knot()}, false);
      path.spline_rate = 1.5;
      path.spline_lead = 0.2;
    }
    const auto acceleration = [&](double s) { return Vec3(path.at(t + s).acceleration); };
    worst.compare(path.jerk(t), derivative(acceleration), "jerk", 1.0);
  }
}

TEST(Path, CircleStartsAtItsTopAndClosesAfterItsPeriod) {
  const double r = 0.15;
  const double w = 0.4;
  const Path path = circle(0.5, -0.2, 0.8, r, w);
  WorstError worst("circle", 1e-14);  // rounding
  for (int step = 0; step < 100; ++step) {
    const double t = 0.2 * step;
    const Vec3 expected(0.5 + r * std::sin(w * t), -0.2 + r * std::cos(w * t) - r, 0.8);
    worst.compare(path.at(t).position, expected, "position");
    worst.compare(path.at(t + 2.0 * M_PI / w).position, expected, "a period later");
    worst.compare(path.at(t).velocity.norm(), r * w, "speed");
    worst.compare(path.at(t).acceleration, Vec3(-w * w * (expected - Vec3(0.5, -0.2 - r, 0.8))),
                  "centripetal acceleration");
  }
  EXPECT_TRUE(path.at(0.0).position.isApprox(Vec3(0.5, -0.2, 0.8), 1e-15));
  EXPECT_GT(path.at(0.0).velocity.x(), 0.0);
}

TEST(Path, PhaseIsAShiftInTime) {
  std::mt19937 generator(413);
  WorstError worst("shift", 1e-13);  // rounding of the angle, up to 60 rad
  for (int sample = 0; sample < 30; ++sample) {
    Path path = random_path(generator);
    Path unshifted = path;
    unshifted.phase = 0.0;
    const double t = random_number(generator, -10.0, 10.0);
    const double later = t + path.phase / path.frequency;
    worst.compare(path.at(t).position, unshifted.at(later).position, "position", 1.0);
    worst.compare(path.at(t).velocity, unshifted.at(later).velocity, "velocity", 1.0);
  }
}

TEST(Path, RestsAtFrequencyZeroWhereItsPhasePutsIt) {
  std::mt19937 generator(414);
  Path path = random_path(generator);
  path.frequency = 1.0;
  const Vec3 start = path.at(0.0).position;
  path.frequency = 0.0;
  for (const double t : {0.0, 1.0, 100.0}) {
    EXPECT_EQ(path.at(t).position, start);
    EXPECT_TRUE(path.at(t).velocity.isZero(0.0));
    EXPECT_TRUE(path.at(t).acceleration.isZero(0.0));
  }
}

TEST(Path, WithoutTermsIsItsCentre) {
  const Path path{Vec3(1.0, 2.0, 3.0), 1.0, 0.5, {}};
  EXPECT_EQ(path.at(7.0).position, path.center);
  EXPECT_TRUE(path.at(7.0).velocity.isZero(0.0));
}

}  // namespace path_test
}  // namespace armtune::internal
