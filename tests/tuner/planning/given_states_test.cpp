// What a start or a goal that is given whole rules out is said before anything is solved.
#include "tuner/planning/tasks/given_states.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "armtune/error.hpp"
#include "core/robot/dynamics.hpp"
#include "sim/scenario/data_files.hpp"
#include "tests/sim/support/files.hpp"
#include "tuner/planning/tasks/plan_problem.hpp"

namespace armtune::internal {
namespace given_states_test {

using test::refused_at;
using testing::HasSubstr;

/// Returns the error with which a task is refused. Its file is the task's.
InputError refusal(const PlanTask& task) {
  InputError error = test::input_error([&] { plan_problem(task); });
  EXPECT_THAT(error, refused_at({.file = shown_path(task.source), .line = 0}));
  return error;
}

/// The largest share of its limit that any joint needs to hold the arm still.
double share_to_hold(const RobotModel& robot, const JointVector& q) {
  Poses poses;
  JointVector tau;
  forward_kinematics(robot.chain, q, poses);
  gravity_torque(robot.chain, poses, tau);
  return (tau.array().abs() / robot.effort_limits().array()).maxCoeff();
}

TEST(GivenStates, WhoCannotHoldTheGoalIsToldWithWhatItTakes) {
  PlanTask task = load_plan_task("ur10_move");
  const RobotModel robot = plant_model(task.scenario);
  task.goal = task.scenario.start_position;
  task.goal[1] = 0.0;  // the arm stretched out: gravity's worst
  const double share = share_to_hold(robot, task.goal);
  ASSERT_GT(share, share_to_hold(robot, task.scenario.start_position));
  task.limits.effort = 1.001 * share;
  EXPECT_NO_THROW(plan_problem(task));
  task.limits.effort = 0.999 * share;
  const InputError error = refusal(task);
  const double limit = task.limits.effort * robot.joints[1].limits.effort;
  EXPECT_THAT(error, refused_at({.key = "goal", .limit = testing::EndsWith(fmt::format("{:.4g}", limit))}));
  EXPECT_NEAR(std::abs(std::stod(error.value())), limit / 0.999, 1e-3 * limit) << "the torque that it takes";
  EXPECT_THAT(error.what(), HasSubstr("torque of shoulder_lift_joint"));
}

TEST(GivenStates, ABlockedStartIsToldToo) {
  PlanTask task = load_plan_task("ur10_move");
  task.limits.effort = 0.999 * share_to_hold(plant_model(task.scenario), task.scenario.start_position);
  const InputError error = refusal(task);
  EXPECT_THAT(error, refused_at({.key = "start"}));
  EXPECT_THAT(error.what(), HasSubstr("torque of"));
}

TEST(GivenStates, AnObstacleThatIsCloserAtTheStartIsNamed) {
  PlanTask task = load_plan_task("ur10_clear_of_obstacles");
  for (MovingObstacle& obstacle : task.scenario.obstacles) obstacle.radius = 0.02;
  Poses poses;
  const RobotModel robot = plant_model(task.scenario);
  forward_kinematics(robot.chain, task.start.position, poses);
  double nearest = (poses.p_0T - task.scenario.obstacles.at(0).path.at(task.at).position).norm();
  for (const MovingObstacle& obstacle : task.scenario.obstacles) {
    const Vec3 center = obstacle.path.at(task.at).position;
    nearest = std::min(nearest, (poses.p_0T - center).norm());
    for (std::size_t i = 1; i < robot.joints.size(); ++i)  // the first stands still
      nearest = std::min(nearest, (poses.p_0B[i] - center).norm());
  }
  nearest -= 0.02;
  EXPECT_NEAR(clearance_at(robot, task.start.position, task.at, task.scenario.obstacles), nearest, 1e-12);
  task.clearance = 0.999 * nearest;
  EXPECT_NO_THROW(plan_problem(task));
  task.clearance = 1.001 * nearest;
  EXPECT_THAT(refusal(task), refused_at({.key = "clearance",
                                         .value = fmt::format("{:.4g}", nearest),
                                         .limit = fmt::format("at least {:.4g}", task.clearance)}));
}

}  // namespace given_states_test
}  // namespace armtune::internal
