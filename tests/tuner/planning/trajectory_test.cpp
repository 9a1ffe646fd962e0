#include "tuner/planning/transcription/trajectory.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tuner/planning/transcription/trajectory_program.hpp"

namespace armtune::internal {
namespace trajectory_test {

/// Two phases, so that the intervals differ.
TimeGrid uneven_grid() {
  TimeGrid grid;
  grid.start = 3.0;
  grid.phases = {{"first", 7, 0.9, false}, {"second", 5, 1.3, false}};
  return grid;
}

/// Values of `motion` at the knots of the grid; velocities at its ends only.
template <typename Motion>
Trajectory sampled(const TimeGrid& grid, const Motion& motion) {
  Trajectory found;
  found.durations = {grid.phases[0].duration, grid.phases[1].duration};
  const Eigen::Index last = grid.intervals();
  found.position.resize(1, last + 1);
  found.velocity.setZero(1, last + 1);
  found.acceleration.setZero(1, last + 1);
  for (int k = 0; k <= last; ++k) {
    const int within = k - grid.phases[0].intervals;
    const double t = within <= 0 ? 0.9 * k / 7 : 0.9 + 1.3 * within / 5;
    found.time.push_back(grid.start + t);
    found.position(0, k) = motion(t)[0];
    if (k == 0 || k == last) found.velocity(0, k) = motion(t)[1];
  }
  return found;
}

TEST(MakeContinuous, ACubicIsFoundAgain) {
  const auto cubic = [](double t) {
    return Eigen::Vector3d{1.0 - 2.0 * t + 3.0 * t * t - 0.7 * t * t * t, -2.0 + 6.0 * t - 2.1 * t * t,
                           6.0 - 4.2 * t};
  };
  const TimeGrid grid = uneven_grid();
  Trajectory motion = sampled(grid, cubic);
  make_continuous(motion);
  for (Eigen::Index k = 0; k <= grid.intervals(); ++k) {
    const Eigen::Vector3d is = cubic(motion.time[static_cast<std::size_t>(k)] - grid.start);
    EXPECT_NEAR(motion.position(0, k), is[0], 1e-13) << k;
    EXPECT_NEAR(motion.velocity(0, k), is[1], 1e-12) << k;
    EXPECT_NEAR(motion.acceleration(0, k), is[2], 1e-11) << k;
  }
}

TEST(MakeContinuous, AnyPositionsAndEndVelocitiesAreKeptByAMotionThatKeepsTheDynamics) {
  const auto wild = [](double t) {
    return Eigen::Vector3d{std::sin(9.0 * t) + std::floor(3.0 * t), 5.0 - 4.0 * t, 0.0};
  };
  TrajectoryTask task;
  task.grid = uneven_grid();
  task.coordinates = {{"q"}};
  Trajectory motion = sampled(task.grid, wild);
  const Trajectory given = motion;
  make_continuous(motion);
  EXPECT_EQ(motion.position, given.position);
  EXPECT_NEAR(motion.velocity(0, 0), 5.0, 1e-12);
  EXPECT_NEAR(motion.velocity(0, task.grid.intervals()), 5.0 - 4.0 * 2.2, 1e-12);
  TrajectoryProgram program(task);
  Eigen::VectorXd residual, row;
  program.evaluate(program.unknowns(motion), residual, row);
  ASSERT_GE(row.size(), 2 * task.grid.intervals());
  EXPECT_LE(row.head(2 * task.grid.intervals()).lpNorm<Eigen::Infinity>(), 1e-12);
}

TEST(InDurationsOf, TheWayIsTheSameAndTheSpeedGoesWithTheDurations) {
  const auto wild = [](double t) { return Eigen::Vector3d{std::sin(3.0 * t), 3.0 * std::cos(3.0 * t), 0.0}; };
  TimeGrid grid = uneven_grid();
  Trajectory motion = sampled(grid, wild);
  make_continuous(motion);
  grid.phases[0].duration *= 2.0;
  grid.phases[1].duration *= 0.5;
  const Trajectory slower = in_durations_of(grid, motion);
  EXPECT_EQ(slower.position, motion.position);
  EXPECT_EQ(slower.velocity.col(0), motion.velocity.col(0)) << "the start is as it is";
  EXPECT_NEAR(slower.velocity(0, 4), 0.5 * motion.velocity(0, 4), 1e-15);
  EXPECT_NEAR(slower.acceleration(0, 4), 0.25 * motion.acceleration(0, 4), 1e-15);
  EXPECT_NEAR(slower.velocity(0, 9), 2.0 * motion.velocity(0, 9), 1e-15);
  EXPECT_NEAR(slower.acceleration(0, 9), 4.0 * motion.acceleration(0, 9), 1e-15);
  EXPECT_NEAR(slower.time[7], grid.start + 1.8, 1e-12);
  EXPECT_NEAR(slower.time[12], grid.start + 1.8 + 0.65, 1e-12);
}

}  // namespace trajectory_test
}  // namespace armtune::internal
