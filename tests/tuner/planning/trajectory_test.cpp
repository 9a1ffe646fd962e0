#include "tuner/planning/transcription/trajectory.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tuner/planning/transcription/trajectory_program.hpp"

namespace armtune {
namespace {

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

}  // namespace
}  // namespace armtune
