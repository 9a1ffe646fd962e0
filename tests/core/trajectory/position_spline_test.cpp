#include "core/trajectory/position_spline.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "armtune/error.hpp"
#include "core/trajectory/cubic_spline.hpp"
#include "core/trajectory/joint_spline.hpp"
#include "core/trajectory/path.hpp"
#include "core/trajectory/polyline.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace position_spline_test {

using test::derivative;
using test::random_number;
using test::random_vec3;
using test::WorstError;

std::vector<double> random_times(std::mt19937& g, std::size_t n) {
  std::vector<double> time{random_number(g, 0.0, 2.0)};
  while (time.size() < n) time.push_back(time.back() + random_number(g, 0.2, 1.5));
  return time;
}

std::vector<MotionPoint<Vec3>> random_knots(std::mt19937& g, std::size_t n) {
  std::vector<MotionPoint<Vec3>> knots;
  for (std::size_t k = 0; k < n; ++k)
    knots.push_back({random_vec3(g, 1.0), random_vec3(g, 1.0), random_vec3(g, 2.0)});
  return knots;
}

/// Position, velocity and acceleration just before t and just after it are the same.
void expect_no_jump(const std::function<MotionPoint<Vec3>(double)>& motion, double t, WorstError& worst) {
  constexpr double kBeside = 1e-9;
  const MotionPoint<Vec3> before = motion(t - kBeside);
  const MotionPoint<Vec3> after = motion(t + kBeside);
  worst.compare(before.position, after.position, "position", 1.0);
  worst.compare(before.velocity, after.velocity, "velocity", 1.0);
  worst.compare(before.acceleration, after.acceleration, "acceleration", 1.0);
}

TEST(PositionSpline, GoesThroughItsKnotsWithoutAJumpAndItsDerivativesAreThose) {
  std::mt19937 g(901);
  WorstError knots("knots", 1e-12), jumps("jumps", 1e-5), velocity("velocity", 1e-8),
      acceleration("acceleration", 1e-8);
  for (int sample = 0; sample < 20; ++sample) {
    const auto time = random_times(g, 6);
    const auto given = random_knots(g, 6);
    const PositionSpline spline(time, given, false);
    const auto motion = [&](double t) { return spline.at(t); };
    for (std::size_t k = 0; k < time.size(); ++k) {
      knots.compare(spline.at(time[k]).position, given[k].position, "position", 1.0);
      knots.compare(spline.at(time[k]).velocity, given[k].velocity, "velocity", 1.0);
      knots.compare(spline.at(time[k]).acceleration, given[k].acceleration, "acceleration", 1.0);
      if (k > 0 && k + 1 < time.size()) expect_no_jump(motion, time[k], jumps);
    }
    const double t = 0.5 * (time[2] + time[3]);
    velocity.compare(spline.at(t).velocity,
                     derivative([&](double s) { return Vec3(spline.at(t + s).position); }), "middle", 1.0);
    acceleration.compare(spline.at(t).acceleration,
                         derivative([&](double s) { return Vec3(spline.at(t + s).velocity); }), "middle",
                         1.0);
  }
}

TEST(PositionSpline, RestsBeforeItsBeginningAndAfterItsEnd) {
  std::mt19937 g(902);
  const auto time = random_times(g, 4);
  const auto knots = random_knots(g, 4);
  const PositionSpline spline(time, knots, false);
  EXPECT_EQ(spline.at(time.front() - 1.0).position, knots.front().position);
  EXPECT_EQ(spline.at(time.back() + 1.0).position, knots.back().position);
  EXPECT_EQ(spline.at(time.back() + 1.0).velocity, Vec3::Zero());
  EXPECT_EQ(spline.at(time.front() - 1.0).acceleration, Vec3::Zero());
}

TEST(PositionSpline, ThatLoopsIsTheSameOneTurnOn) {
  std::mt19937 g(903);
  const auto time = random_times(g, 5);
  auto knots = random_knots(g, 5);
  EXPECT_THROW(PositionSpline(time, knots, true), InputError);
  knots.back() = knots.front();
  const PositionSpline spline(time, knots, true);
  const double turn = time.back() - time.front();
  WorstError same("a turn on", 1e-9);
  for (double t = -3.0; t < 9.0; t += 0.17) {
    same.compare(spline.at(t).position, spline.at(t + turn).position, "position", 1.0);
    same.compare(spline.at(t).velocity, spline.at(t + turn).velocity, "velocity", 1.0);
  }
}

TEST(PositionSpline, TimesThatDoNotRiseAreRefused) {
  std::mt19937 g(904);
  EXPECT_THROW(PositionSpline({0.0, 1.0, 1.0}, random_knots(g, 3), false), InputError);
  EXPECT_THROW(PositionSpline({0.0}, random_knots(g, 1), false), InputError);
  EXPECT_THROW(PositionSpline({0.0, 1.0}, random_knots(g, 3), false), InputError);
}

TEST(CubicSpline, IsAtRestAtBothEndsAndItsAccelerationHasNoJump) {
  std::mt19937 g(905);
  WorstError ends("rest", 1e-12), linear("acceleration is linear between knots", 1e-9), jumps("jumps", 1e-9);
  for (int sample = 0; sample < 20; ++sample) {
    const auto n = static_cast<std::size_t>(2 + sample % 7);
    const auto time = random_times(g, n);
    std::vector<Vec3> positions;
    for (std::size_t k = 0; k < n; ++k) positions.push_back(random_vec3(g, 1.0));
    const auto knots = cubic_spline(time, positions);
    for (std::size_t k = 0; k < n; ++k) EXPECT_EQ(knots[k].position, positions[k]);
    ends.compare(Vec3(knots.front().velocity), Vec3(Vec3::Zero()), "begin", 1.0);
    ends.compare(Vec3(knots.back().velocity), Vec3(Vec3::Zero()), "end", 1.0);
    // The quintics of these knots are the cubic: their acceleration is linear, and ends in the next knot's.
    const PositionSpline spline(time, knots, false);
    for (std::size_t k = 0; k + 1 < n; ++k) {
      const double middle = 0.5 * (time[k] + time[k + 1]);
      linear.compare(spline.at(middle).acceleration,
                     Vec3(0.5 * (knots[k].acceleration + knots[k + 1].acceleration)), "middle", 1.0);
      // The cubic from a knot's position, velocity and acceleration arrives at the next one.
      const double h = time[k + 1] - time[k];
      const Vec3 jerk = (knots[k + 1].acceleration - knots[k].acceleration) / h;
      jumps.compare(Vec3(knots[k].velocity + h * knots[k].acceleration + 0.5 * h * h * jerk),
                    knots[k + 1].velocity, "velocity", 1.0);
      jumps.compare(Vec3(knots[k].position + h * knots[k].velocity + 0.5 * h * h * knots[k].acceleration +
                         h * h * h / 6.0 * jerk),
                    knots[k + 1].position, "position", 1.0);
    }
  }
}

TEST(Polyline, KeepsItsSpeedOnTheSidesAndStaysInsideItsCorners) {
  std::mt19937 g(906);
  for (const bool closed : {false, true}) {
    const std::vector<Vec3> corners = {{0, 0, 0}, {0.4, 0, 0.1}, {0.4, 0.5, 0}, {0, 0.3, 0.2}};
    const double speed = 0.2, blend = 0.05;
    const PositionSpline line = polyline(corners, speed, blend, closed);
    EXPECT_EQ(line.loops(), closed);
    const auto motion = [&](double t) { return line.at(t); };
    WorstError jumps("jumps", 1e-6);
    for (std::size_t k = 1; k + 1 < line.time().size(); ++k) expect_no_jump(motion, line.time()[k], jumps);
    if (closed) expect_no_jump(motion, line.end(), jumps);
    const std::size_t sides = corners.size() - (closed ? 0 : 1);
    // A blend is as long in time as its two halves at full speed.
    EXPECT_NEAR(line.time()[closed ? 2 : 1] - line.time()[closed ? 1 : 0], 2.0 * blend / speed, 1e-12);
    EXPECT_NEAR(line.time().back() - line.time()[line.time().size() - 2], 2.0 * blend / speed, 1e-12);
    double fastest = 0.0;
    for (double t = line.begin(); t <= line.end(); t += 1e-3) {
      const MotionPoint<Vec3> at = line.at(t);
      fastest = std::max(fastest, at.velocity.norm());
      // Off every side by no more than the corner's blend allows; on one of them at its speed wherever the
      // nearest corner is farther away than the blend.
      double nearest_corner = HUGE_VAL, off = HUGE_VAL;
      for (const Vec3& corner : corners)
        nearest_corner = std::min(nearest_corner, (at.position - corner).norm());
      for (std::size_t s = 0; s < sides; ++s) {
        const Vec3 from = corners[s], side = corners[(s + 1) % corners.size()] - from;
        const double along = std::clamp((at.position - from).dot(side) / side.squaredNorm(), 0.0, 1.0);
        off = std::min(off, (at.position - from - along * side).norm());
      }
      EXPECT_LT(off, 0.5 * blend);
      if (nearest_corner > blend) {
        EXPECT_LT(off, 1e-12);
        EXPECT_NEAR(at.velocity.norm(), speed, 1e-12);
      }
    }
    EXPECT_LT(fastest, 1.6 * speed);
    if (!closed) {
      EXPECT_EQ(line.at(line.begin()).velocity, Vec3::Zero());
      EXPECT_LT((line.at(line.end()).position - corners.back()).norm(), 1e-12);
    }
  }
}

TEST(Polyline, OfACornerThatIsBlendedWholeHasNoStraightPiece) {
  const PositionSpline line = polyline({{0, 0, 0}, {0.2, 0, 0}, {0.2, 0.2, 0}}, 0.1, 0.1, false);
  EXPECT_EQ(line.time().size(), 4U);  // speeding up, the corner, slowing down
}

TEST(PathOfKnots, IsItsSplineAboutItsCentre) {
  std::mt19937 g(907);
  auto knots = random_knots(g, 4);
  Path path;
  path.center = Vec3(1.0, 2.0, 3.0);
  path.spline = std::make_shared<const PositionSpline>(std::vector<double>{0.0, 1.0, 2.5, 3.0}, knots, false);
  EXPECT_LT((path.at(1.0).position - path.center - knots[1].position).norm(), 1e-12);
  EXPECT_LT((path.at(1.0).velocity - knots[1].velocity).norm(), 1e-12);
  EXPECT_FALSE(path.rests());
  EXPECT_EQ(path.period(), 0.0);
  const Path slow = path;
  path.spline_rate = 2.0;
  path.spline_lead = 0.3;
  EXPECT_LT((path.at(0.4).position - slow.at(1.1).position).norm(), 1e-12);
  WorstError velocity("velocity", 1e-8), acceleration("acceleration", 1e-8);
  velocity.compare(path.at(0.6).velocity,
                   derivative([&](double s) { return Vec3(path.at(0.6 + s).position); }), "faster");
  acceleration.compare(path.at(0.6).acceleration,
                       derivative([&](double s) { return Vec3(path.at(0.6 + s).velocity); }), "faster");
  path = slow;
  knots.back() = knots.front();
  path.spline = std::make_shared<const PositionSpline>(std::vector<double>{0.5, 1.0, 2.5, 3.0}, knots, true);
  EXPECT_EQ(path.period(), 2.5);
  path.spline_rate = 2.0;
  EXPECT_EQ(path.period(), 1.25);
  EXPECT_EQ(Path().period(), 0.0);
  EXPECT_TRUE(Path().rests());
  EXPECT_NEAR((Path{Vec3::Zero(), -4.0, 0.0, {{1, Vec3::UnitX(), Vec3::UnitY()}}}).period(), M_PI / 2.0,
              1e-15);
}

}  // namespace position_spline_test
}  // namespace armtune::internal
