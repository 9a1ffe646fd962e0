#include "core/control/state_machine.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>

namespace armtune {
namespace {

constexpr ControlState kLeave = ControlState::kLeaveSingularity;
constexpr ControlState kReturn = ControlState::kReturnToTrajectory;
constexpr ControlState kFollow = ControlState::kFollowTrajectory;
constexpr ControlState kAvoid = ControlState::kAvoidObstacles;

constexpr double kInfluence = 0.3;
constexpr double kRelease = 0.4;
constexpr double kNear = 0.2;      // within r_o
constexpr double kBetween = 0.35;  // outside r_o, inside the release radius
constexpr double kFar = 0.5;

TEST(NextState, FollowsTheTableOfAllStatesAndInputs) {
  struct Row {
    ControlState from;
    double distance;
    // by (joint trajectory finished, return finished): no no, no yes, yes no, yes yes
    std::array<ControlState, 4> to;
  };
  const Row table[] = {
      {kLeave, kNear, {kLeave, kLeave, kReturn, kReturn}},
      {kLeave, kBetween, {kLeave, kLeave, kReturn, kReturn}},
      {kLeave, kFar, {kLeave, kLeave, kReturn, kReturn}},
      {kReturn, kNear, {kAvoid, kAvoid, kAvoid, kAvoid}},
      {kReturn, kBetween, {kReturn, kFollow, kReturn, kFollow}},
      {kReturn, kFar, {kReturn, kFollow, kReturn, kFollow}},
      {kFollow, kNear, {kAvoid, kAvoid, kAvoid, kAvoid}},
      {kFollow, kBetween, {kFollow, kFollow, kFollow, kFollow}},
      {kFollow, kFar, {kFollow, kFollow, kFollow, kFollow}},
      {kAvoid, kNear, {kAvoid, kAvoid, kAvoid, kAvoid}},
      {kAvoid, kBetween, {kAvoid, kAvoid, kAvoid, kAvoid}},
      {kAvoid, kFar, {kReturn, kReturn, kReturn, kReturn}},
  };
  for (const Row& row : table) {
    for (std::size_t i = 0; i < row.to.size(); ++i) {
      const bool joint_finished = i >= 2;
      const bool return_finished = i % 2 == 1;
      EXPECT_EQ(next_state(row.from, {joint_finished, return_finished, row.distance, kInfluence, kRelease}),
                row.to[i])
          << name(row.from) << " at " << row.distance << " m, " << joint_finished << return_finished;
    }
  }
}

TEST(NextState, BordersBelongToTheOutside) {
  EXPECT_EQ(next_state(kFollow, {true, true, kInfluence, kInfluence, kRelease}), kFollow);
  EXPECT_EQ(next_state(kAvoid, {true, true, kRelease, kInfluence, kRelease}), kReturn);
}

TEST(NextState, WithEqualRadiiAvoidanceEndsWhereItBegan) {
  EXPECT_EQ(next_state(kAvoid, {true, false, kInfluence, kInfluence, kInfluence}), kReturn);
  EXPECT_EQ(next_state(kReturn, {true, false, 0.999 * kInfluence, kInfluence, kInfluence}), kAvoid);
}

TEST(NextState, WithoutObstaclesAvoidanceIsNeverEntered) {
  const double none = std::numeric_limits<double>::infinity();
  EXPECT_EQ(next_state(kReturn, {true, false, none, kInfluence, kRelease}), kReturn);
  EXPECT_EQ(next_state(kFollow, {true, true, none, kInfluence, kRelease}), kFollow);
  EXPECT_EQ(next_state(kAvoid, {true, true, none, kInfluence, kRelease}), kReturn);
}

TEST(ControlStateName, IsThePublishedOne) {
  EXPECT_EQ(std::string(name(kLeave)), "leaveSingularity");
  EXPECT_EQ(std::string(name(kReturn)), "returnToTrajectory");
  EXPECT_EQ(std::string(name(kFollow)), "followTrajectory");
  EXPECT_EQ(std::string(name(kAvoid)), "avoidObstacles");
}

}  // namespace
}  // namespace armtune
