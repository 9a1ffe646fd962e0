// What a start or a goal that is given whole rules out is said before anything is solved.
#include "tuner/planning/tasks/given_states.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armtune/error.hpp"
#include "core/robot/dynamics.hpp"
#include "sim/scenario/data_files.hpp"
#include "tests/sim/support/files.hpp"
#include "tuner/planning/tasks/plan_problem.hpp"

namespace armtune::internal {
namespace given_states_test {

using testing::AllOf;
using testing::HasSubstr;

std::string refusal(const PlanTask& task) {
  try {
    plan_problem(task);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
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
  EXPECT_EQ(refusal(task), "");
  task.limits.effort = 0.999 * share;
  EXPECT_THAT(refusal(task), AllOf(HasSubstr("ur10_move.yaml: goal: torque of shoulder_lift_joint would be"),
                                   HasSubstr("the task's limit is"), HasSubstr("limits/effort")));
}

TEST(GivenStates, ABlockedStartIsToldToo) {
  PlanTask task = load_plan_task("ur10_move");
  task.limits.effort = 0.999 * share_to_hold(plant_model(task.scenario), task.scenario.start_position);
  EXPECT_THAT(refusal(task), HasSubstr("start: torque of"));
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
  EXPECT_EQ(refusal(task), "");
  task.clearance = 1.001 * nearest;
  EXPECT_THAT(refusal(task), AllOf(HasSubstr(": clearance: distance to "), HasSubstr("'start'")));
}

}  // namespace given_states_test
}  // namespace armtune::internal
