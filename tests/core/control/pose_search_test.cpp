#include "core/control/pose_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"

namespace armtune::internal {
namespace pose_search_test {

double no_preference(const JointVector&) {
  return 0.0;
}

TEST(PoseSearch, FindsPosesThatTheArmCanTake) {
  std::mt19937 generator(41);
  for (const RobotModel& arm : test::all_arms()) {
    if (arm.n() < 5) continue;  // position and axis are five conditions
    for (int sample = 0; sample < 5; ++sample) {
      const JointVector q = test::random_configuration(generator, arm);
      const Poses there = test::poses_at(arm.chain, q);
      const ToolGoal goal{there.p_0T, Vec3(there.p_0T + 0.7 * there.R_0T.col(2))};
      const JointVector near = q + test::random_vector(generator, arm.n(), 0.01);
      const auto found = best_pose(arm, goal, near, no_preference);
      ASSERT_TRUE(found.has_value()) << arm.name;
      const Poses poses = test::poses_at(arm.chain, *found);
      EXPECT_LT((poses.p_0T - goal.tool).norm(), 1e-8) << arm.name;
      EXPECT_LT((poses.R_0T.col(2) - there.R_0T.col(2)).norm(), 1e-8) << arm.name;
      EXPECT_GE(tightest_joint(arm, *found).margin, 0.0) << arm.name;
    }
  }
}

TEST(PoseSearch, FindsAWholeOrientation) {
  std::mt19937 generator(42);
  for (const RobotModel& arm : test::all_arms()) {
    if (arm.n() < 6) continue;
    for (int sample = 0; sample < 5; ++sample) {
      const JointVector q = test::random_configuration(generator, arm);
      const Poses there = test::poses_at(arm.chain, q);
      const ToolGoal goal{there.p_0T, {}, Eigen::Quaterniond(there.R_0T)};
      const JointVector near = q + test::random_vector(generator, arm.n(), 0.01);
      const auto found = best_pose(arm, goal, near, no_preference);
      ASSERT_TRUE(found.has_value()) << arm.name;
      const Poses poses = test::poses_at(arm.chain, *found);
      EXPECT_LT((poses.p_0T - goal.tool).norm(), 1e-8) << arm.name;
      EXPECT_LT((poses.R_0T - there.R_0T).norm(), 1e-8) << arm.name;
    }
  }
}

TEST(PoseSearch, FindsNothingBeyondTheReach) {
  const RobotModel arm = test::ur10();
  EXPECT_FALSE(best_pose(arm, {Vec3(1.01 * reach(arm), 0.0, 0.0), {}}, JointVector(JointVector::Zero(6)),
                         no_preference)
                   .has_value());
}

TEST(PoseSearch, TakesTheHighestScoreAndNothingWithoutOne) {
  const RobotModel arm = test::ur10();
  const ToolGoal goal{Vec3(-0.6, 0.1, 0.4), {}};
  std::vector<double> scores;
  const JointVector zero = JointVector::Zero(6);
  const auto best =
      best_pose(arm, goal, zero, [&](const JointVector& q) { return scores.emplace_back(q[0]); });
  ASSERT_TRUE(best.has_value());
  ASSERT_GT(scores.size(), 3U);
  EXPECT_EQ((*best)[0], *std::max_element(scores.begin(), scores.end()));
  EXPECT_LT(*std::min_element(scores.begin(), scores.end()), (*best)[0]);
  EXPECT_FALSE(best_pose(arm, goal, zero, [](const JointVector&) { return std::nan(""); }).has_value());
  const auto again = best_pose(arm, goal, zero, [](const JointVector& q) { return q[0]; });
  EXPECT_EQ(*again, *best);
}

TEST(PoseSearch, SamplesLieWithinTheLimitsAndDiffer) {
  const RobotModel arm = test::seven_joint_arm();
  for (unsigned sample = 0; sample < 50; ++sample) {
    const JointVector q = sample_position(arm, sample);
    EXPECT_GT(tightest_joint(arm, q).margin, 0.0);
    EXPECT_EQ(sample_position(arm, sample), q);
    EXPECT_NE(sample_position(arm, sample + 1), q);
  }
}

TEST(PoseSearch, SamplesFillRangesFarFromZero) {
  RobotModel arm = test::random_arm(6, 11, true);
  ASSERT_EQ(arm.chain.motion[1], JointMotion::kPrismatic);
  arm.joints[0].limits = {true, 3.5, 5.0, 1.0, 1.0};  // beyond half a turn
  arm.joints[1].limits = {true, 4.0, 6.0, 1.0, 1.0};  // metres
  arm.joints[2].limits = {true, -20.0, 20.0, 1.0, 1.0};
  arm.joints[3].limits = {true, 2.5, 12.0, 1.0, 1.0};
  JointVector least = sample_position(arm, 0);
  JointVector most = least;
  for (unsigned sample = 0; sample < 50; ++sample) {
    const JointVector q = sample_position(arm, sample);
    EXPECT_GT(tightest_joint(arm, q).margin, 0.0);
    least = least.cwiseMin(q);
    most = most.cwiseMax(q);
  }
  const JointVector spread = most - least;
  EXPECT_GT(spread[0], 1.0);
  EXPECT_GT(spread[1], 1.5);
  for (const int joint : {2, 3}) {
    EXPECT_GT(spread[joint], 4.5) << joint;
    EXPECT_LE(spread[joint], 2.0 * M_PI) << "a turn is enough";
  }
  EXPECT_LE(most[2], M_PI);
}

TEST(PoseSearch, TheTightestJointIsTheOneWithTheLeastShareLeft) {
  RobotModel arm = test::ur10();
  JointVector q = JointVector::Zero(6);
  for (JointInfo& joint : arm.joints) joint.limits = {true, -1.0, 1.0, 1.0, 1.0};
  q[4] = 0.6;
  EXPECT_EQ(tightest_joint(arm, q).joint, 4);
  EXPECT_NEAR(tightest_joint(arm, q).margin, 0.2, 1e-12);
  q[2] = -1.5;
  EXPECT_EQ(tightest_joint(arm, q).joint, 2);
  EXPECT_NEAR(tightest_joint(arm, q).margin, -0.25, 1e-12);
  arm.joints[2].limits.has_position = false;
  EXPECT_EQ(tightest_joint(arm, q).joint, 4);
}

}  // namespace pose_search_test
}  // namespace armtune::internal
