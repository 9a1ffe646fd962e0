#include "tuner/session/controller_study_session.hpp"

#include "armtune/error.hpp"
#include "core/common/file_path.hpp"
#include "sim/scenario/data_files.hpp"

namespace armtune::internal {

std::optional<ControllerStudyFiles> make_controller_study(ControllerStudyInputs inputs,
                                                          const std::string& folder,
                                                          const MotionPlanner& planner,
                                                          SessionObserver& observer,
                                                          const std::atomic<bool>& stop) {
  if (planner.timing) {
    inputs.timing = [&](const JointGoals& goals) {
      auto timed = planner.timing(goals, stop, progress_of(observer, "planning the motion of " + goals.file));
      observer.part_is_over();
      return timed;
    };
  }
  inputs.tool_motion = planner.tool_motion;
  return write_controller_study(inputs, folder);
}

std::string study_folder_beside(RunPlace& place, const ControllerStudyInputs& inputs, bool several_ranks) {
  if (place.folder.empty()) place.folder = default_run_folder(stem(inputs.robot));
  if (!place.resume) {
    if (several_ranks)
      throw InputError(
          "tune: several MPI ranks cannot write a study together; write it first with 'armtune init' and the "
          "same options, then tune it");
    refuse_used_folder(place.folder);
  }
  return absolute_path(place.folder) + "_study";
}

}  // namespace armtune::internal
