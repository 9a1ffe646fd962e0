// A motion that is planned round what stands in its way.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/scenario/robot_file.hpp"
#include "tests/core/support/states.hpp"
#include "tests/sim/cell/rods.hpp"
#include "tests/sim/support/files.hpp"
#include "tuner/planning/output/limit_use.hpp"
#include "tuner/planning/output/plan_sample.hpp"
#include "tuner/planning/tasks/plan_problem.hpp"
#include "tuner/planning/tasks/solve_plan.hpp"

namespace armtune::internal {
namespace plan_in_cell_test {

/// A UR5e that turns its shoulder by 140 degrees, across a wall that stands in the way.
std::string task_files(const test::TemporaryFolder& folder, const std::string& clearance) {
  folder.write("cell.yaml", R"(
robot: ur5e
control_period: 0.002
duration: 5
start_position_deg: [-70, -60, 80, -110, -90, 0]
path: {hold: [0.4, 0.1, 0.4]}
targets: [{name: a, hold: [0.4, 0.1, 0]}]
theta_start: {model_scale: 1}
cell:
  floor: -0.1
  parts: [{name: wall, box: [0.4, 0.03, 0.4], center: [0.7, 0, 0.18]}]
)");
  return folder.write(
      "move.yaml",
      "task: move\nscenario: cell.yaml\nstart: {position: [-1.22, -1.05, 1.4, -1.92, -1.57, 0]}\n"
      "goal: [1.22, -1.05, 1.4, -1.92, -1.57, 0]\nknots: 31\n" +
          clearance);
}

double least_distance(const PlanTask& task, const PlanProblem& problem, const Trajectory& trajectory,
                      Clearance kind) {
  PlanTask watched = task;
  watched.clearance = 1e-3;
  PlanSampler sampler(watched, problem, trajectory);
  double least = INFINITY;
  for (Eigen::Index k = 0; k + 1 < trajectory.position.cols(); ++k) {
    for (int part = 0; part < 10; ++part) {
      least = std::min(least, least_of(kind, sampler.within(k, 0.1 * part).cell).distance);
    }
  }
  return least;
}

TEST(PlanInACell, GoesRoundAWallThatItWouldCrossOtherwise) {
  const test::TemporaryFolder folder;
  // A task that says nothing keeps away as well.
  PlanTask blind = load_plan_task(task_files(folder, ""));
  EXPECT_EQ(blind.clearance, 0.02);
  EXPECT_THAT([&] { load_plan_task(task_files(folder, "clearance: 0\n")); },
              test::refused_at({.line = 6, .key = "clearance", .value = "0", .limit = "above 0"}));
  blind.clearance = 0.0;
  const PlanProblem across = plan_problem(blind);
  const PlannedTrajectory crossed = solve_plan(across);
  EXPECT_LT(least_distance(blind, across, crossed.trajectory, Clearance::kCell), 0.0);
  const PlanTask task = load_plan_task(task_files(folder, "clearance: 0.03\n"));
  const PlanProblem problem = plan_problem(task);
  const PlannedTrajectory planned = solve_plan(problem);
  ASSERT_EQ(planned.result.status, PlanStatus::kSolved);
  // The wall and the floor; links are never far from each other.
  EXPECT_GT(least_distance(task, problem, planned.trajectory, Clearance::kCell), 0.02)
      << "between the knots too";
  EXPECT_GT(least_distance(task, problem, planned.trajectory, Clearance::kFloor), 0.02);
  EXPECT_GT(least_distance(task, problem, planned.trajectory, Clearance::kSelf), 0.0);
  const std::vector<LimitUse> uses = limit_uses(task, problem, planned);
  EXPECT_EQ(worst_between(uses, {LimitKind::kObstacle}).use, nullptr);
  for (const LimitKind kind : {LimitKind::kCellPart, LimitKind::kFloor}) {
    const WorstUse worst = worst_between(uses, {kind});
    ASSERT_NE(worst.use, nullptr) << name(kind);
    EXPECT_THAT(worst.use->limit, testing::HasSubstr(kind == LimitKind::kFloor ? "floor" : "wall"));
    EXPECT_EQ(worst.use->lower, 0.03);
  }
  EXPECT_GE(planned.trajectory.durations[0], (1.0 - 1e-6) * crossed.trajectory.durations[0]);
}

}  // namespace plan_in_cell_test
}  // namespace armtune::internal
