#include "sim/scenario/path_walk.hpp"

#include <gtest/gtest.h>

#include "core/control/pose_search.hpp"
#include "sim/scenario/start_of_task.hpp"

namespace armtune::internal {
namespace path_walk_test {

TEST(PathWalk, FollowsThePathAndMeasuresTheArmOnIt) {
  Scenario scenario = load_scenario("moving_target");
  const JointVector q = best_start_of_task(scenario);
  const PathWalk walk = walk_path(scenario, q, 0.0);
  EXPECT_LT(walk.error.value, 1e-4);
  EXPECT_GT(walk.manipulability.value, 0.0);
  EXPECT_LE(walk.manipulability.value, walk.largest_manipulability);
  // The place is where the path is at that time.
  EXPECT_EQ(walk.manipulability.tool, scenario.path.at(walk.manipulability.time).position);
}

TEST(PathWalk, EndsEarlyWhereItIsLostAndIsTheSameWhereItIsNot) {
  const Scenario scenario = load_scenario("moving_target");
  int followed = 0, shorter = 0;
  for (unsigned sample = 0; sample < 60; ++sample) {
    JointVector q = sample_position(*scenario.robot, sample);
    reach_goal(*scenario.robot, {scenario.path.at(0.0).position, {}}, q);
    const PathWalk whole = walk_path(scenario, q, 0.2);
    const PathWalk early = walk_path(scenario, q, 0.2, 0.0, WalkUntil::kLost);
    ASSERT_EQ(can_follow(early), can_follow(whole)) << sample;
    if (!can_follow(whole)) {
      shorter += early.steps < whole.steps ? 1 : 0;
      continue;
    }
    ++followed;
    EXPECT_EQ(early.steps, whole.steps);
    EXPECT_EQ(early.margin.value, whole.margin.value);
    EXPECT_EQ(early.load.value, whole.load.value);
    EXPECT_EQ(early.manipulability.value, whole.manipulability.value);
  }
  EXPECT_GE(followed, 3);
  EXPECT_GE(shorter, 3);
}

TEST(PathWalk, LongScenariosAreGoneAlongInABoundedNumberOfSteps) {
  Scenario scenario = load_scenario("moving_target");  // 40 s; its target moves on
  const JointVector q = best_start_of_task(scenario);
  EXPECT_EQ(walk_path(scenario, q, 0.0).steps, 2000);
  for (const double duration : {800.0, 1e5}) {
    scenario.duration = duration;
    const PathWalk walk = walk_path(scenario, q, 0.0);
    EXPECT_EQ(walk.steps, 20000) << duration;
    EXPECT_LT(walk.error.value, 1e-3) << duration << ": longer steps are short enough to follow the path";
  }
}

}  // namespace path_walk_test
}  // namespace armtune::internal
