#pragma once
// The work of the command `armtune init`, and of `armtune tune` before it tunes the controller of a robot. It
// writes a study from the robot's files (controller_study.hpp), and plans motions for files that have only
// joint goals or waypoints of the tool.

#include <atomic>
#include <functional>
#include <optional>
#include <string>

#include "tuner/controller_study/controller_study.hpp"
#include "tuner/session/journalled_run.hpp"

namespace armtune::internal {

/// Finds motions for files that have only joint goals or waypoints of the tool. If a function is empty, files
/// that need it are refused.
struct MotionPlanner {
  /// Plans a motion through joint goals. Reports the number of finished moves and of all moves. Returns
  /// nothing if `stop` became true.
  std::function<std::optional<TimedGoals>(const JointGoals& goals, const std::atomic<bool>& stop,
                                          const std::function<void(std::size_t, std::size_t)>& progress)>
      timing = {};
  ToolMotion tool_motion = {};  ///< see ControllerStudyInputs
};

/// Writes a study with the motions of this planner, as write_controller_study does. Reports the progress of
/// planning to the observer. Returns nothing, and writes nothing, if `stop` became true.
std::optional<ControllerStudyFiles> make_controller_study(ControllerStudyInputs inputs,
                                                          const std::string& folder,
                                                          const MotionPlanner& planner,
                                                          SessionObserver& observer,
                                                          const std::atomic<bool>& stop);

/// Returns the folder of the study that a run tunes. Its name is that of the run's folder with "_study"
/// appended. If place.folder is empty, it is set to the default run folder first. Throws InputError for a new
/// run if there are several MPI ranks, or if the run's folder exists and is not empty.
std::string study_folder_beside(RunPlace& place, const ControllerStudyInputs& inputs, bool several_ranks);

}  // namespace armtune::internal
