// Planned trajectories followed in Simbody by the adaptive law, with the true theta.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "sim/csv/text_file.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/rollouts.hpp"
#include "tuner/planning/output/plan_files.hpp"
#include "tuner/planning/output/scenario_file.hpp"
#include "tuner/planning/tasks/solve_plan.hpp"

namespace armtune::internal {
namespace follow_plan_test {

/// What following a plan came to.
struct Followed {
  double error = 0.0;     ///< largest |q - qd| of any joint [rad]
  double velocity = 0.0;  ///< largest |q'| over its limit
  double torque = 0.0;    ///< largest |tau| over its limit, as commanded
  int saturated = 0;      ///< periods
  Metrics metrics;
  Scenario scenario;
};

Followed follow(const PlanTask& task, const test::TemporaryFolder& folder,
                const std::string& gains = "published") {
  const PlanProblem problem = plan_problem(task);
  const PlannedTrajectory planned = solve_plan(problem);
  EXPECT_EQ(planned.result.status, PlanStatus::kSolved) << task.name;
  write_text_file(folder / "trajectory.csv", trajectory_csv(task, problem, planned.trajectory));
  const std::string file = folder / planned_scenario_name(task);
  write_text_file(file, planned_scenario_yaml(task));
  Followed found;
  found.scenario = load_scenario(file);
  const RobotModel& robot = *found.scenario.robot;
  const RolloutResult result =
      Rollout(found.scenario, Stepper::kMidpoint)
          .run(load_gains(gains, joint_names(robot)), [&](const Observation& o) {
            EXPECT_EQ(o.control->state, ControlState::kFollowPlan);
            const JointVector wanted = point_at(planned.trajectory, o.time).position.head(robot.n());
            found.error = std::max(found.error, (*o.q - wanted).lpNorm<Eigen::Infinity>());
            found.velocity =
                std::max(found.velocity, (o.qd->array().abs() / robot.velocity_limits().array()).maxCoeff());
            found.torque =
                std::max(found.torque,
                         (o.control->commanded.array().abs() / robot.effort_limits().array()).maxCoeff());
            found.saturated += o.control->saturated ? 1 : 0;
            return true;
          });
  EXPECT_EQ(result.status, RolloutStatus::kCompleted) << task.name << ": " << result.reason;
  EXPECT_NEAR(result.metrics[Metric::kJointErrorMax], found.error, 1e-12) << "the CSV holds every bit";
  found.metrics = result.metrics;
  return found;
}

class FollowPlan : public testing::TestWithParam<const char*> {
 protected:
  PlanTask task_ = load_plan_task(GetParam());
  test::TemporaryFolder folder_;
};

/// Every joint this close to it at all times [rad].
constexpr double kClose = 1e-3;

TEST_P(FollowPlan, WithRoomForTheFeedbackEveryJointIsOnItsPlanInsideItsLimits) {
  task_.limits.velocity = task_.limits.effort = 0.95;
  const Followed found = follow(task_, folder_);
  RecordProperty("error", fmt::format("{:.3g}", found.error));
  EXPECT_LT(found.error, kClose);
  EXPECT_LT(found.velocity, 1.0);
  EXPECT_LT(found.torque, 1.0);
  EXPECT_EQ(found.saturated, 0);
  EXPECT_GE(found.metrics[Metric::kJointPositionMinMargin], 0.0);
  // The plan uses what it was given, and so does the arm.
  EXPECT_GT(std::max(found.velocity, found.torque), 0.94);
}

TEST_P(FollowPlan, AtItsWholeLimitsItIsStillOnItsPlanAndPassesThemByTheFeedbackAlone) {
  const Followed found = follow(task_, folder_);
  RecordProperty("error", fmt::format("{:.3g}", found.error));
  EXPECT_LT(found.error, kClose);
  EXPECT_LT(found.velocity, 1.005);
  EXPECT_LT(found.torque, 1.02);
}

TEST_P(FollowPlan, GainsWithGovernorAndBarrierFollowItAsWell) {
  task_.limits.velocity = task_.limits.effort = 0.95;
  const Followed found = follow(task_, folder_, "extended_tuned");
  EXPECT_LT(found.error, 1.1 * kClose);  // theta starts right, and adapts along a filtered motion
  EXPECT_LT(found.velocity, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Bundled, FollowPlan,
                         testing::Values("ur10_move", "ur10_switch", "ur10_return", "ur10_fastest_circle",
                                         "ur10_clear_of_obstacles"));

TEST(FollowPlanOfASwitch, TheGazeIsAtTheNextTargetWhenThePlanSaysSo) {
  const test::TemporaryFolder folder;
  const PlanTask task = load_plan_task("ur10_switch");
  const Followed found = follow(task, folder);
  const double turn = found.scenario.planned->end() - task.at - task.hold;
  EXPECT_NEAR(found.metrics[Metric::kReacquisitionTime], turn, 1.5 * found.scenario.control_period);
}

TEST(FollowPlanScenario, IsTheTasksOwnWithThePlanInFrontAndAControllerThatKnowsTheArm) {
  const test::TemporaryFolder folder;
  const Followed found = follow(load_plan_task("ur10_return"), folder);
  const Scenario& s = found.scenario;
  const Scenario base = load_scenario("moving_target");
  EXPECT_EQ(s.name, "planned_ur10_return");
  EXPECT_EQ(s.start_time, 10.0);
  EXPECT_EQ(s.path.at(11.0).position, base.path.at(11.0).position);
  EXPECT_EQ(s.theta.model_scale, 1.0);
  EXPECT_FALSE(s.has_task());
  ASSERT_FALSE(base.clearance);
  ASSERT_TRUE(s.clearance) << "the base has no cell, but shapes of the arm are known";
  EXPECT_TRUE(s.clearance->has(Clearance::kSelf));
}

TEST(FollowPlanScenario, KeepsTheCellOfTheTasksOwn) {
  PlanTask task = load_plan_task("ur10_return");
  Cell cell;
  cell.floor = -1.0;
  task.scenario.clearance = std::make_shared<const ClearanceModel>(task.scenario.robot, cell);
  EXPECT_THAT(planned_scenario_yaml(task), testing::Not(testing::HasSubstr("cell")));
  RobotModel bare = task.scenario.clearance->robot();
  bare.shapes.clear();
  task.scenario.robot = std::make_shared<const RobotModel>(bare);
  task.scenario.clearance = nullptr;
  EXPECT_THAT(planned_scenario_yaml(task), testing::Not(testing::HasSubstr("cell"))) << "nothing to check";
}

}  // namespace follow_plan_test
}  // namespace armtune::internal
