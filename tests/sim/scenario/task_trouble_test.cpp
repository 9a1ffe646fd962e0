#include "sim/scenario/task_trouble.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "core/control/pose_search.hpp"
#include "sim/scenario/gains_file.hpp"
#include "sim/scenario/start_of_task.hpp"
#include "tests/core/support/states.hpp"

namespace armtune::internal {
namespace task_trouble_test {

using testing::AllOf;
using testing::HasSubstr;

/// Of the UR10 [deg]: its fifth joint at zero, where the fourth and the sixth turn about one axis.
const JointVector kWristInLine = (JointVector(6) << 20.0, -90.0, -90.0, -60.0, 0.0, 0.0).finished();

Gains published(const Scenario& scenario) {
  return load_gains("published", joint_names(*scenario.robot));
}

TEST(TaskTrouble, NothingIsWrongWithThePublishedTask) {
  for (const char* name : {"moving_target", "fixed_target", "target_switch"}) {
    const Scenario scenario = load_scenario(name);
    EXPECT_EQ(task_trouble(scenario, published(scenario)), "") << name;
  }
}

TEST(TaskTrouble, SaysWhereThePathLeavesTheWorkspace) {
  Scenario scenario = load_scenario("moving_target");
  scenario.path.terms = {{1, Vec3(0.0, 0.0, 0.0), Vec3(-0.9, 0.0, 0.0)}};  // out to 1.55 m
  const std::string trouble = task_trouble(scenario, published(scenario));
  EXPECT_THAT(trouble, AllOf(HasSubstr("leaves the workspace of ur10"), HasSubstr("point (-1.")));
  scenario.path.center = Vec3(-3.0, 0.0, 0.5);
  EXPECT_THAT(task_trouble(scenario, published(scenario)),
              AllOf(HasSubstr("cannot place its tool at (-3"), HasSubstr("move the path")));
}

TEST(TaskTrouble, TheDistanceItNamesIsTheLeastThatTheArmCanHave) {
  Scenario scenario = load_scenario("moving_target");
  scenario.path.center = Vec3(-1.2, 0.04, 0.5);
  scenario.path.terms = {{1, Vec3(0.4, 0.0, 0.0), Vec3(0.0, 0.4, 0.0)}};
  const std::string trouble = task_trouble(scenario, published(scenario));
  std::smatch said;
  ASSERT_TRUE(
      std::regex_search(trouble, said, std::regex(R"(point \((\S+), (\S+), (\S+)\) m, .* than (\S+) m)")))
      << trouble;
  const Vec3 place(std::stod(said[1]), std::stod(said[2]), std::stod(said[3]));
  const double named = std::stod(said[4]);
  EXPECT_GT(named, 1e-3);
  const Chain& chain = scenario.robot->chain;
  double least = 10.0;
  for (unsigned sample = 0; sample < 20000; ++sample) {
    least = std::min(least,
                     (test::poses_at(chain, sample_position(*scenario.robot, sample)).p_0T - place).norm());
  }
  EXPECT_LE(named, least + 1e-3) << "printed to three digits";
  EXPECT_GT(named, least - 0.15) << "so many samples come nearly as close";
}

TEST(TaskTrouble, LapsThatWindAJointUpAreAllGone) {
  Scenario scenario = load_scenario("moving_target");
  // About the base, its tool down: every lap turns the first joint once, which may turn twice.
  scenario.path = {
      Vec3(0.0, 0.0, 0.4), 2.0 * M_PI / 10.0, 0.0, {{1, Vec3(0.7, 0.0, 0.0), Vec3(0.0, 0.7, 0.0)}}};
  scenario.targets = {{"below", {Vec3(0.0, 0.0, -20.0), 0.0, 0.0, {}}}};
  scenario.duration = 8.0;
  EXPECT_EQ(task_trouble(scenario, published(scenario)), "");
  scenario.duration = 40.0;
  EXPECT_THAT(task_trouble(scenario, published(scenario)),
              AllOf(HasSubstr("shoulder_pan_joint exceeds its position limits"), HasSubstr("at 40 s")));
  // It winds up, not down: only the upper limit is in its way.
  auto free_below = std::make_shared<RobotModel>(*scenario.robot);
  free_below->joints[0].limits.lower = -100.0;
  free_below->joints[5].limits.lower = -100.0;  // it winds as well
  free_below->joints[5].limits.upper = 100.0;
  scenario.robot = free_below;
  EXPECT_THAT(task_trouble(scenario, published(scenario)),
              HasSubstr("shoulder_pan_joint exceeds its position limits"));
  free_below->joints[0].limits = {true, -6.3, 100.0, free_below->joints[0].limits.velocity,
                                  free_below->joints[0].limits.effort};
  EXPECT_EQ(task_trouble(scenario, published(scenario)), "");
}

/// Out by `sway` and back through the place where the UR10's first and last wrist axis are in line, the gaze
/// at a target ahead of it.
Scenario through_the_wrist(const Vec3& sway, double frequency) {
  Scenario scenario = load_scenario("moving_target");
  const Poses poses = test::poses_at(scenario.robot->chain, in_si(*scenario.robot, kWristInLine));
  scenario.path = {poses.p_0T, frequency, 0.0, {{1, sway, Vec3::Zero()}}};
  scenario.targets = {{"ahead", {poses.p_0T + 0.5 * poses.R_0T.col(2), 0.0, 0.0, {}}}};
  return scenario;
}

/// From the pose of its beginning that is close to q.
PathWalk walk_from(const Scenario& scenario, JointVector q) {
  const ToolGoal begin{scenario.path.at(0.0).position, scenario.targets[0].path.at(0.0).position};
  EXPECT_TRUE(reach_goal(*scenario.robot, begin, q));
  return walk_path(scenario, q, 0.0);
}

TEST(TaskTrouble, SaysWhereASingularityIsPassed) {
  const Scenario scenario = through_the_wrist(Vec3(0.0, 0.0, 0.1), 0.6);
  JointVector q = in_si(*scenario.robot, kWristInLine);
  q[4] += 0.3;
  const PathWalk walk = walk_from(scenario, q);
  EXPECT_LT(walk.error.value, 1e-3);
  EXPECT_LT((walk.manipulability.tool - scenario.path.center).norm(), 2e-3);  // a step takes 1.2 mm there
  EXPECT_FALSE(is_clear(walk));
  EXPECT_THAT(trouble(walk, scenario).problem,
              AllOf(HasSubstr("singularity"), HasSubstr("manipulability is")));
}

TEST(TaskTrouble, SaysWhereTheToolPassesItsOwnTarget) {
  Scenario scenario = load_scenario("moving_target");
  scenario.targets = {{"on_it", {scenario.path.at(5.0).position + Vec3(0.0, 0.0, 0.005), 0.0, 0.0, {}}}};
  EXPECT_THAT(task_trouble(scenario, published(scenario)),
              AllOf(HasSubstr("passes too close to its gaze target"), HasSubstr("m away")));
}

TEST(TaskTrouble, ProblemAndAdviceAreOneSentenceAndBothEmptyWithoutAProblem) {
  Scenario scenario = load_scenario("moving_target");
  const JointVector q = best_start_of_task(scenario);
  EXPECT_EQ(trouble(walk_path(scenario, q, 0.0), scenario).text(), "");
  scenario.targets = {{"on_it", {scenario.path.at(5.0).position + Vec3(0.0, 0.0, 0.005), 0.0, 0.0, {}}}};
  const WalkTrouble found = trouble(walk_path(scenario, q, 0.0), scenario);
  EXPECT_THAT(found.problem, AllOf(HasSubstr("gaze target"), testing::Not(HasSubstr(found.advice))));
  EXPECT_THAT(found.text(), AllOf(testing::StartsWith(found.problem), testing::EndsWith(found.advice)));
}

TEST(TaskTrouble, APathThatIsLostInASingularityHasNotLeftTheWorkspace) {
  // Aside to the line on which the wrist could turn over in time.
  const Scenario scenario = through_the_wrist(Vec3(0.15, 0.0, 0.0), 2.0);
  JointVector q(6);
  q << 0.44, -1.43, -1.39, -3.46, -0.16, 0.0;
  const PathWalk walk = walk_from(scenario, q);
  EXPECT_GT(walk.error.value, 1e-2);
  EXPECT_THAT(trouble(walk, scenario).problem,
              AllOf(HasSubstr("singularity"), testing::Not(HasSubstr("workspace"))));
}

TEST(TaskTrouble, SaysWhichJointLeavesItsLimits) {
  Scenario scenario = load_scenario("moving_target");
  const JointVector q = best_start_of_task(scenario);
  auto narrow = std::make_shared<RobotModel>(*scenario.robot);
  narrow->joints[0].limits.lower = q[0] - 0.02;
  narrow->joints[0].limits.upper = q[0] + 0.02;
  scenario.robot = narrow;
  const PathWalk walk = walk_path(scenario, q, 0.0);
  EXPECT_EQ(walk.joint, 0);
  EXPECT_THAT(trouble(walk, scenario).problem,
              AllOf(HasSubstr(narrow->joints[0].name), HasSubstr("exceeds its position limits")));
}

}  // namespace task_trouble_test
}  // namespace armtune::internal
