#include "tuner/planning/tasks/tool_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/control/measured_arm.hpp"
#include "core/control/pose_search.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"

namespace armtune::internal {
namespace tool_motion_test {

TEST(ToolMotion, TheBestPoseOfFiveJointsIsTheOneThatMovesToolAndGazeBest) {
  std::mt19937 generator(61);
  const RobotModel arm = test::random_arm(5, 21, false);
  const JointVector rest = JointVector::Zero(arm.n());
  MeasuredArm measured;
  const auto worth = [&](const JointVector& q) {
    measured.measure(arm.chain, q, rest, {0.0, 1.0, 0.0}, TaskMask::kPositionAndAxis);
    return measured.inverse.manipulability();
  };
  int choices = 0;
  for (int sample = 0; sample < 10; ++sample) {
    const JointVector q = test::random_configuration(generator, arm);
    const Poses there = test::poses_at(arm.chain, q);
    const ToolGoal goal{there.p_0T, Vec3(there.p_0T + 0.7 * there.R_0T.col(2))};
    double first = -1.0;
    double most = -1.0;
    best_pose(arm, goal, q, [&](const JointVector& found) {
      const double m = worth(found);
      if (first < 0.0) first = m;
      most = std::max(most, m);
      return 0.0;
    });
    const auto pose = pose_at(arm, goal.tool, goal.target, q, BestPose::kLargestManipulability);
    ASSERT_TRUE(pose.has_value());
    EXPECT_DOUBLE_EQ(worth(*pose), most);
    if (most > 1.01 * first) ++choices;
  }
  EXPECT_GT(choices, 0) << "where the first pose is always the best, nothing is said";
}

}  // namespace tool_motion_test
}  // namespace armtune::internal
