// The optima of plans against those of Ipopt, another method and another implementation, on the same
// programs.

#include <gtest/gtest.h>

#include <cmath>

#include "ipopt_solver.hpp"
#include "tuner/planning/tasks/solve_plan.hpp"

namespace armtune::internal {
namespace ipopt_test {

/// Where Ipopt begins.
enum class From { kTheSameGuess, kOurOptimum };

/// On the same grid; Ipopt knows no coarser ones.
void expect_same_optimum(PlanTask task, From from_where = From::kTheSameGuess) {
  task.knots = 36;
  task.smoothness = 1e-6;
  const PlanProblem problem = plan_problem(task);
  const PlannedTrajectory ours = solve_plan(problem);
  ASSERT_EQ(ours.result.status, PlanStatus::kSolved) << task.name;

  TrajectoryProgram program(problem.task(problem.grid));
  const Eigen::VectorXd from =
      from_where == From::kOurOptimum ? ours.result.z : program.unknowns(problem.guess);
  IpoptOptions options;
  options.stationarity = options.violation = 1e-9;
  const IpoptRun ipopt = solve_by_ipopt(program, from, {}, options);
  ASSERT_EQ(ipopt.word, "solved") << task.name;
  const double objective = program.objective(ipopt.z);
  EXPECT_NEAR(ours.objective(), objective, 1e-4 * std::abs(objective)) << task.name;
  testing::Test::RecordProperty(task.name + "_ours", std::to_string(ours.objective()));
  testing::Test::RecordProperty(task.name + "_ipopt", std::to_string(objective));
  const Trajectory theirs = program.trajectory(ipopt.z);
  EXPECT_NEAR(ours.trajectory.durations[0], theirs.durations[0], 1e-4 * theirs.durations[0]) << task.name;
}

class AgainstIpopt : public testing::TestWithParam<const char*> {};

TEST_P(AgainstIpopt, FindsTheSameOptimum) {
  expect_same_optimum(load_plan_task(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Tasks, AgainstIpopt,
                         testing::Values("ur10_move", "ur10_switch", "ur10_return", "ur10_fastest_circle",
                                         "ur10_least_gaze_error"));

// Past obstacles there are several optima: from the common guess Ipopt ends in one that waits for an obstacle
// to pass, at two and a half times our duration. Ours has to be one of its own.
TEST(IpoptUnderLimits, HasNothingBetterBesideAPlanPastObstacles) {
  expect_same_optimum(load_plan_task("ur10_clear_of_obstacles"), From::kOurOptimum);
}

TEST(IpoptUnderLimits, FindsTheSameLeastErrorOfALapThatIsTooFast) {
  PlanTask task = load_plan_task("ur10_lap");
  task.scenario.path.frequency *= 8.0;  // a turn in 1.25 s
  task.duration = 1.25;
  task.limits.velocity = 0.25;
  task.start.position = JointVector(6);
  task.start.position << 0.35, -1.57, -1.57, -1.57, 1.57, 0.0;  // at rest, off the path
  expect_same_optimum(task);
}

TEST(IpoptUnderLimits, FindsTheSameOptimumUnderAccelerationAndJerkLimits) {
  PlanTask task = load_plan_task("ur10_move");
  task.limits.acceleration = JointVector::Constant(6, 8.0);
  task.limits.jerk = JointVector::Constant(6, 100.0);
  expect_same_optimum(task);
}

}  // namespace ipopt_test
}  // namespace armtune::internal
