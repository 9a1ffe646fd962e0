#include "sim/scenario/task_places.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/robot/holding_load.hpp"
#include "sim/scenario/walk_extremes.hpp"
#include "tests/core/support/arms.hpp"

namespace armtune::internal {
namespace task_places_test {

constexpr double kLowest = 0.3;  // m

/// How far the tool looks down, from -1 (straight up) to 1.
double down(const RobotModel& arm, const TaskPlace& place) {
  Poses poses;
  forward_kinematics(arm.chain, place.q, poses);
  return -height_of(poses.R_0T.col(2), arm);
}

TEST(TaskPlaces, ComeBestFirstAndMostLookDown) {
  const RobotModel arm = test::ur10();
  const auto places = task_places(arm, TaskMask::kPositionAndAxis, kLowest, false);
  ASSERT_EQ(places.size(), 200U);
  EXPECT_TRUE(std::is_sorted(places.begin(), places.end(),
                             [](const TaskPlace& a, const TaskPlace& b) { return a.score > b.score; }));
  EXPECT_GT(std::count_if(places.begin(), places.end(),
                          [&arm](const TaskPlace& place) { return down(arm, place) > 0.0; }),
            110);
}

// An arm that can hardly hold itself has few of them among the first two thousand.
TEST(TaskPlaces, AThoroughLookFindsBetterOnesAndOnlyThoseThatWillDo) {
  const RobotModel arm = test::random_arm(5, 1033, true);
  const auto quick = task_places(arm, TaskMask::kPosition, kLowest, false);
  const auto thorough = task_places(arm, TaskMask::kPosition, kLowest, true);
  ASSERT_EQ(thorough.size(), 500U);
  EXPECT_GE(thorough.front().score, quick.front().score);
  for (const TaskPlace& place : thorough) {
    Poses poses;
    forward_kinematics(arm.chain, place.q, poses);
    EXPECT_GT(height_of(poses.p_0T, arm), kLowest);
    EXPECT_LT(holding_load(arm.chain, place.q, arm.effort_limits()).share, kMostLoad);
  }
}

}  // namespace task_places_test
}  // namespace armtune::internal
