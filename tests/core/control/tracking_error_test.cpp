// The error of a tool that is moved away from its desired motion by a known amount is that amount.

#include "core/control/tracking_error.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/support/states.hpp"

namespace armtune::internal {
namespace tracking_error_test {

constexpr double kRounding = 1e-12;

/// A desired motion, and a tool that differs from it by pose and rate.
struct MovedTool {
  ControlOutput desired;
  Vec6 pose, rate, twist;
  Mat3 R_0T;
  Vec3 p_0T;

  explicit MovedTool(unsigned seed, ControlState state, bool slerping) {
    std::mt19937 generator(seed);
    desired.state = state;
    desired.slerping = slerping;
    desired.desired.position = test::random_vec3(generator, 1.0);
    desired.desired.velocity = test::random_vec3(generator, 1.0);
    desired.desired_gaze.orientation = test::random_orientation(generator);
    desired.desired_gaze.angular_velocity = test::random_vec3(generator, 1.0);
    pose << test::random_vec3(generator, 0.3), test::random_vec3(generator, 0.3);
    rate << test::random_vec3(generator, 0.5), test::random_vec3(generator, 0.5);
    p_0T = desired.desired.position + pose.head<3>();
    R_0T = (rotation_exp(Vec3(pose.tail<3>())) * desired.desired_gaze.orientation).toRotationMatrix();
    twist << desired.desired.velocity + rate.head<3>(),
        desired.desired_gaze.angular_velocity + rate.tail<3>();
  }
  TrackingError error(const Vec3& turn, TaskMask mask) const {
    return tracking_error(R_0T, p_0T, twist, desired, turn, mask);
  }
};

TEST(TrackingError, IsWhatTheToolWasMovedBy) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const MovedTool tool(seed, ControlState::kFollowTrajectory, true);
    const TrackingError error = tool.error(Vec3(9.0, 9.0, 9.0), TaskMask::kPose);
    EXPECT_LT((error.pose - tool.pose).norm(), kRounding);
    EXPECT_LT((error.rate - tool.rate).norm(), kRounding);
  }
}

TEST(TrackingError, OutsideASlerpTheOrientationErrorIsMinusTheTurnToTheAim) {
  const MovedTool tool(1, ControlState::kReturnToTrajectory, false);
  const Vec3 turn(0.1, -0.2, 0.3);
  const TrackingError error = tool.error(turn, TaskMask::kPose);
  EXPECT_EQ(Vec3(error.pose.tail<3>()), Vec3(-turn));
  EXPECT_LT((error.pose - tool.pose).head<3>().norm(), kRounding);
}

TEST(TrackingError, HasNoPositionWhileObstaclesAreAvoided) {
  const MovedTool tool(2, ControlState::kAvoidObstacles, true);
  const TrackingError error = tool.error(Vec3::Zero(), TaskMask::kPose);
  EXPECT_EQ(error.pose.head<3>().norm(), 0.0);
  EXPECT_EQ(error.rate.head<3>().norm(), 0.0);
  EXPECT_LT((error.pose - tool.pose).tail<3>().norm(), kRounding);
  EXPECT_LT((error.rate - tool.rate).tail<3>().norm(), kRounding);
}

TEST(TrackingError, OfAFreeTurnHasNoPartAboutTheToolsAxis) {
  for (const bool slerping : {true, false}) {
    const MovedTool tool(3, ControlState::kFollowTrajectory, slerping);
    const Vec3 axis = tool.R_0T.col(2);
    const TrackingError error = tool.error(Vec3(axis.cross(Vec3(0.2, 0.1, 0.3))), TaskMask::kPositionAndAxis);
    EXPECT_NEAR(error.pose.tail<3>().dot(axis), 0.0, kRounding);
    EXPECT_NEAR(error.rate.tail<3>().dot(axis), 0.0, kRounding);
    EXPECT_LT((error.rate.tail<3>().cross(axis) - tool.rate.tail<3>().cross(axis)).norm(), kRounding);
  }
}

}  // namespace tracking_error_test
}  // namespace armtune::internal
