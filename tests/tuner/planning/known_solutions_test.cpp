// Motions of one coordinate whose optimum is known in closed form.

#include <gtest/gtest.h>

#include <cmath>

#include "tuner/planning/transcription/refining_solver.hpp"
#include "tuner/planning/transcription/state_term.hpp"

namespace armtune::internal {
namespace known_solutions_test {

using Eigen::VectorXd;

VectorXd one(double value) {
  return VectorXd::Constant(1, value);
}

/// One coordinate from 0 to 1, at rest at both ends.
struct Move {
  double velocity = INFINITY, acceleration = INFINITY, jerk = INFINITY;
  bool rest_of_acceleration = true;  ///< q'' = 0 at both ends, too
  Smoothness smoothness;
  double duration = 4.0;
  bool free = true;
  int intervals = 200;

  TrajectoryTask on(const TimeGrid& grid) const {
    TrajectoryTask task;
    Coordinate x;
    x.name = "x";
    x.velocity = velocity;
    x.acceleration = acceleration;
    x.jerk = jerk;
    task.coordinates = {x};
    task.grid = grid;
    task.duration_cost = 1.0;
    task.smoothness = smoothness;
    const auto zero = rest_of_acceleration ? one(0.0) : VectorXd();
    task.terms.push_back(given_state("start", {"x"}, {"m"}, 0, {one(0.0), one(0.0), zero}));
    task.terms.push_back(given_state("end", {"x"}, {"m"}, grid.intervals(), {one(1.0), one(0.0), zero}));
    return task;
  }
  PlannedTrajectory solved() const {
    TimeGrid grid;
    grid.phases = {{"move", intervals, duration, free, 0.01, 100.0}};
    Trajectory guess;
    guess.durations = {duration};
    guess.time = {0.0, duration};
    guess.position = Eigen::RowVector2d(0.0, 1.0);
    guess.velocity = Eigen::RowVector2d::Constant(1.0 / duration);
    guess.acceleration = Eigen::RowVector2d::Zero();
    return solve_refining([this](const TimeGrid& g) { return on(g); }, grid, guess, {}, {});
  }
};

void expect_solved(const PlannedTrajectory& planned) {
  EXPECT_EQ(planned.result.status, PlanStatus::kSolved);
  EXPECT_LE(planned.result.last.violation, 1e-8);
  EXPECT_LE(planned.result.last.stationarity, 1e-6);
}

TEST(KnownSolutions, LeastTimeUnderAnAccelerationLimitIsBangBang) {
  Move move;
  move.acceleration = 1.0;
  move.rest_of_acceleration = false;
  const PlannedTrajectory planned = move.solved();
  expect_solved(planned);
  EXPECT_NEAR(planned.trajectory.durations[0], 2.0, 1e-3);  // 2 sqrt(d/a)
  EXPECT_NEAR(planned.trajectory.acceleration(0, 50), 1.0, 1e-3);
  EXPECT_NEAR(planned.trajectory.acceleration(0, 150), -1.0, 1e-3);
}

TEST(KnownSolutions, LeastTimeUnderVelocityAccelerationAndJerkLimitsHasSevenPieces) {
  Move move;
  move.velocity = 0.6;
  move.acceleration = 1.0;
  move.jerk = 5.0;
  const PlannedTrajectory planned = move.solved();
  expect_solved(planned);
  EXPECT_NEAR(planned.trajectory.durations[0], 1.0 / 0.6 + 0.6 / 1.0 + 1.0 / 5.0, 1e-3);  // d/v + v/a + a/j
}

TEST(KnownSolutions, LeastJerkIsTheQuintic) {
  Move move;
  move.smoothness.jerk = 1.0;
  move.free = false;
  move.duration = 1.0;
  move.intervals = 1000;
  const PlannedTrajectory planned = move.solved();
  expect_solved(planned);
  double worst = 0.0;
  for (int k = 0; k <= move.intervals; ++k) {
    const double s = planned.trajectory.time[static_cast<std::size_t>(k)];
    worst = std::max(
        worst, std::abs(planned.trajectory.position(0, k) - s * s * s * (10.0 - 15.0 * s + 6.0 * s * s)));
  }
  EXPECT_LE(worst, 1e-6);
}

TEST(KnownSolutions, LeastAccelerationIsTheCubic) {
  Move move;
  move.smoothness.acceleration = 1.0;
  move.rest_of_acceleration = false;
  move.free = false;
  move.duration = 2.0;
  const PlannedTrajectory planned = move.solved();
  expect_solved(planned);
  for (int k = 0; k <= move.intervals; ++k) {
    const double s = planned.trajectory.time[static_cast<std::size_t>(k)] / 2.0;
    ASSERT_NEAR(planned.trajectory.position(0, k), s * s * (3.0 - 2.0 * s), 1e-9) << k;
  }
}

TEST(KnownSolutions, TooLittleTimeIsInfeasibleAndTheAccelerationLimitIsInTheWay) {
  Move move;
  move.acceleration = 1.0;
  move.rest_of_acceleration = false;
  move.smoothness.jerk = 1e-5;
  move.free = false;
  move.duration = 1.5;  // 2 s are needed
  const PlannedTrajectory planned = move.solved();
  EXPECT_EQ(planned.result.status, PlanStatus::kInfeasible);
  EXPECT_GT(planned.result.last.violation, 0.1);
}

TEST(KnownSolutions, AFeasibleDurationIsFeasible) {
  Move move;
  move.acceleration = 1.0;
  move.rest_of_acceleration = false;
  move.smoothness.jerk = 1e-5;
  move.free = false;
  move.duration = 2.01;
  expect_solved(move.solved());
}

TEST(KnownSolutions, AStartAboveTheVelocityLimitIsInfeasible) {
  Move move;
  move.velocity = 0.6;
  move.acceleration = 10.0;
  const auto task = [&](const TimeGrid& grid) {
    TrajectoryTask moving = move.on(grid);
    moving.terms[0] = given_state("start", {"x"}, {"m"}, 0, {one(0.0), one(1.0), VectorXd()});
    return moving;
  };
  TimeGrid grid;
  grid.phases = {{"move", 50, 3.0, true, 0.01, 100.0}};
  Trajectory guess;
  guess.durations = {3.0};
  guess.time = {0.0, 3.0};
  guess.position = Eigen::RowVector2d(0.0, 1.0);
  guess.velocity = Eigen::RowVector2d::Constant(0.33);
  guess.acceleration = Eigen::RowVector2d::Zero();
  EXPECT_EQ(solve_refining(task, grid, guess, {}, {}).result.status, PlanStatus::kInfeasible);
}

}  // namespace known_solutions_test
}  // namespace armtune::internal
