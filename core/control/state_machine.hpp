#pragma once
// The controller's states and the pure functions that decide the transitions between them.

namespace armtune::internal {

enum class ControlState {
  kLeaveSingularity,    ///< moves the joints from the start pose to a goal, away from singularities
  kReturnToTrajectory,  ///< moves the tool back to its path
  kFollowTrajectory,    ///< follows the path with the tool
  kAvoidObstacles,      ///< lets the repulsion of obstacles move the arm
  kFollowPlan           ///< follows a planned joint trajectory
};

constexpr const char* name(ControlState state) {
  switch (state) {
    case ControlState::kLeaveSingularity:
      return "leaveSingularity";
    case ControlState::kReturnToTrajectory:
      return "returnToTrajectory";
    case ControlState::kFollowTrajectory:
      return "followTrajectory";
    case ControlState::kAvoidObstacles:
      return "avoidObstacles";
    case ControlState::kFollowPlan:
      return "followPlan";
  }
  return "";
}

/// Returns the state of the first period. planned: true if there is a joint trajectory to follow.
constexpr ControlState first_state(bool planned) {
  return planned ? ControlState::kFollowPlan : ControlState::kLeaveSingularity;
}

/// True for states whose reference is a joint motion. They track neither a position of the tool nor a gaze.
constexpr bool tracks_joints(ControlState state) {
  return state == ControlState::kLeaveSingularity || state == ControlState::kFollowPlan;
}

struct TransitionInput {
  bool joint_trajectory_finished = false;  ///< true after joint_trajectory_duration
  bool return_finished = false;            ///< true if the return trajectory has reached the path
  double obstacle_distance = 0.0;          ///< see obstacle_distance.hpp [m]; infinite without obstacles
  double influence_radius = 0.0;           ///< r_o [m]
  double release_radius = 0.0;             ///< >= r_o [m]
  bool plan_finished = false;              ///< true if the planned trajectory is over
};

/// Returns the state of this period from that of the last one. leaveSingularity is not interrupted, because
/// the Cartesian law that avoidObstacles needs cannot be used near the singularity of the start pose.
/// followPlan can be interrupted. It is not resumed, because the arm was pushed away from the plan and the
/// plan's time has passed.
constexpr ControlState next_state(ControlState state, const TransitionInput& in) {
  if (state == ControlState::kLeaveSingularity) {
    return in.joint_trajectory_finished ? ControlState::kReturnToTrajectory : state;
  }
  if (state == ControlState::kAvoidObstacles) {
    return in.obstacle_distance < in.release_radius ? state : ControlState::kReturnToTrajectory;
  }
  if (in.obstacle_distance < in.influence_radius) return ControlState::kAvoidObstacles;
  if (state == ControlState::kFollowPlan && in.plan_finished) return ControlState::kReturnToTrajectory;
  if (state == ControlState::kReturnToTrajectory && in.return_finished) {
    return ControlState::kFollowTrajectory;
  }
  return state;
}

}  // namespace armtune::internal
