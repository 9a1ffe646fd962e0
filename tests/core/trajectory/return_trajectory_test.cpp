#include "core/trajectory/return_trajectory.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace return_trajectory_test {

using test::random_vec3;
using test::WorstError;

constexpr double kTimeGain = 7.0;  // s/m

Path circle() {
  const double r = 0.15;
  return {Vec3(0.5, -0.2 - r, 0.8), 0.6, 0.3, {{1, Vec3(0.0, r, 0.0), Vec3(r, 0.0, 0.0)}}};
}

TEST(ReturnDuration, IsTheDistanceToWhereThePathWillBeByANaiveDuration) {
  std::mt19937 generator(451);
  const Path path = circle();
  WorstError worst("duration", 1e-14);  // rounding
  for (int sample = 0; sample < 50; ++sample) {
    const Vec3 p = random_vec3(generator, 1.0);
    const double t0 = test::random_number(generator, 0.0, 20.0);
    // Step one: how long to where the path is now. Step two: where will it be by then, how long to there.
    const double dt = kTimeGain * Vec3(p - path.at(t0).position).norm();
    const Vec3 ahead = path.at(t0 + dt).position;
    const double dt_star = kTimeGain * Vec3(p - ahead).norm();
    worst.compare(return_duration(p, path, t0, kTimeGain), dt_star, "random");
    worst.compare(return_trajectory({p, Vec3::Zero(), Vec3::Zero()}, path, t0, kTimeGain).duration(), dt_star,
                  "trajectory");
  }
}

TEST(ReturnDuration, IsNeverShorterThanATwentiethOfASecond) {
  const Path point{Vec3(0.5, 0.0, 0.8), 0.0, 0.0, {}};
  EXPECT_EQ(return_duration(point.center, point, 3.0, kTimeGain), 0.05);
  EXPECT_EQ(return_duration(point.center + Vec3(0.007, 0, 0), point, 3.0, kTimeGain), 0.05);  // 0.049 s
  EXPECT_NEAR(return_duration(point.center + Vec3(0.008, 0, 0), point, 3.0, kTimeGain), 0.056, 1e-15);
}

TEST(ReturnTrajectory, LeavesWithTheToolsMotionAndJoinsThePathsOwn) {
  std::mt19937 generator(452);
  const Path path = circle();
  WorstError worst("ends", 1e-11);  // as the quintic's
  for (int sample = 0; sample < 50; ++sample) {
    const MotionPoint<Vec3> start{random_vec3(generator, 1.0), random_vec3(generator, 0.5),
                                  random_vec3(generator, 0.5)};
    const double t0 = test::random_number(generator, 0.0, 20.0);
    const Quintic<Vec3> way = return_trajectory(start, path, t0, kTimeGain);
    const MotionPoint<Vec3> end = path.at(t0 + way.duration());
    worst.compare(way.at(0.0).position, start.position, "start position", 1.0);
    worst.compare(way.at(0.0).velocity, start.velocity, "start velocity", 1.0);
    worst.compare(way.at(0.0).acceleration, start.acceleration, "start acceleration", 1.0);
    worst.compare(way.at(way.duration()).position, end.position, "end position", 1.0);
    worst.compare(way.at(way.duration()).velocity, end.velocity, "end velocity", 1.0);
    worst.compare(way.at(way.duration()).acceleration, end.acceleration, "end acceleration", 1.0);
  }
}

}  // namespace return_trajectory_test
}  // namespace armtune::internal
