#pragma once
// The controller's four states and the one pure function that moves between them.

namespace armtune {

enum class ControlState { kLeaveSingularity, kReturnToTrajectory, kFollowTrajectory, kAvoidObstacles };

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
  }
  return "";
}

struct TransitionInput {
  bool joint_trajectory_finished = false;  ///< joint_trajectory_duration is over
  bool return_finished = false;            ///< the return trajectory has reached the path
  double obstacle_distance = 0.0;          ///< closest joint origin to obstacle centre [m], infinite if none
  double influence_radius = 0.0;           ///< r_o [m]
  double release_radius = 0.0;             ///< >= r_o [m]
};

/// State of this period from that of the last one. leaveSingularity is not interrupted: the Cartesian law
/// that avoidObstacles needs cannot be used near the start pose's singularity.
constexpr ControlState next_state(ControlState state, const TransitionInput& in) {
  if (state == ControlState::kLeaveSingularity) {
    return in.joint_trajectory_finished ? ControlState::kReturnToTrajectory : state;
  }
  if (state == ControlState::kAvoidObstacles) {
    return in.obstacle_distance < in.release_radius ? state : ControlState::kReturnToTrajectory;
  }
  if (in.obstacle_distance < in.influence_radius) return ControlState::kAvoidObstacles;
  if (state == ControlState::kReturnToTrajectory && in.return_finished) {
    return ControlState::kFollowTrajectory;
  }
  return state;
}

}  // namespace armtune
