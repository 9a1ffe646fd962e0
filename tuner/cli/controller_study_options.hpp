#pragma once
// The options --robot, --controllers and --trajectory. They create a study, which is armtune's description
// of a tuning problem, from files that a robot's user already has: the arm, the ROS parameters of its
// controller, and motions.

#include "tuner/controller_study/controller_study.hpp"
#include "tuner/session/journalled_run.hpp"

namespace CLI {
class App;
}

namespace armtune::internal::cli {

/// Adds the options. required: true if all three must be given; otherwise all three or none must be given.
void add_controller_study_options(CLI::App& command, ControllerStudyInputs& inputs, bool required);

/// Writes the study and prints the assumptions made; see write_controller_study. Returns the study's path;
/// empty if it was interrupted.
std::string make_controller_study(ControllerStudyInputs inputs, const std::string& folder);

/// Calls make_controller_study for a run, and returns the same. The study's folder is place.folder with
/// "_study" appended. If place.folder is empty, it is set to the default run folder first. If the run is
/// resumed, its study exists already, and nothing is written. Throws InputError for a new run if there are
/// several MPI ranks, or if the run's folder exists and is not empty.
std::string study_beside_run(const ControllerStudyInputs& inputs, RunPlace& place, bool several_ranks);

}  // namespace armtune::internal::cli
