#include "core/control/state_machine.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>

namespace armtune::internal {
namespace state_machine_test {

constexpr ControlState kLeave = ControlState::kLeaveSingularity;
constexpr ControlState kReturn = ControlState::kReturnToTrajectory;
constexpr ControlState kFollow = ControlState::kFollowTrajectory;
constexpr ControlState kAvoid = ControlState::kAvoidObstacles;
constexpr ControlState kPlan = ControlState::kFollowPlan;

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

TEST(NextState, APlanEndsByItselfOrAtAnObstacleAndIsNotTakenUpAgain) {
  for (const bool others : {false, true}) {  // what other states wait for
    const auto from = [&](ControlState state, double distance, bool finished) {
      return next_state(state, {others, others, distance, kInfluence, kRelease, finished});
    };
    EXPECT_EQ(from(kPlan, kFar, false), kPlan);
    EXPECT_EQ(from(kPlan, kBetween, false), kPlan);
    EXPECT_EQ(from(kPlan, kInfluence, false), kPlan);
    EXPECT_EQ(from(kPlan, kNear, false), kAvoid);
    EXPECT_EQ(from(kPlan, kFar, true), kReturn);
    EXPECT_EQ(from(kPlan, kNear, true), kAvoid);
    for (const ControlState other : {kLeave, kReturn, kFollow, kAvoid}) {
      for (const double distance : {kNear, kBetween, kFar}) {
        EXPECT_EQ(from(other, distance, false), from(other, distance, true)) << name(other);
        EXPECT_NE(from(other, distance, false), kPlan) << name(other);
      }
    }
  }
  EXPECT_EQ(first_state(true), kPlan);
  EXPECT_EQ(first_state(false), kLeave);
}

TEST(TracksJoints, HoldsOfTheStatesWithAJointMotionForAReference) {
  for (const ControlState state : {kLeave, kPlan}) EXPECT_TRUE(tracks_joints(state)) << name(state);
  for (const ControlState state : {kReturn, kFollow, kAvoid})
    EXPECT_FALSE(tracks_joints(state)) << name(state);
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

TEST(ControlStateName, IsThePublishedOneWhereThereIsOne) {
  EXPECT_EQ(std::string(name(kLeave)), "leaveSingularity");
  EXPECT_EQ(std::string(name(kReturn)), "returnToTrajectory");
  EXPECT_EQ(std::string(name(kFollow)), "followTrajectory");
  EXPECT_EQ(std::string(name(kAvoid)), "avoidObstacles");
  EXPECT_EQ(std::string(name(kPlan)), "followPlan");
}

}  // namespace state_machine_test
}  // namespace armtune::internal
