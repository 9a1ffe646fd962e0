#pragma once
// The planner of motions for studies that are made from a robot's files.

#include "tuner/planning/session/timed_goals.hpp"
#include "tuner/planning/session/tool_waypoints.hpp"
#include "tuner/session/controller_study_session.hpp"

namespace armtune::internal {

/// Returns the functions that plan through joint goals and along waypoints of the tool.
inline MotionPlanner motion_planner() {
  return {time_goals, motion_along};
}

}  // namespace armtune::internal
