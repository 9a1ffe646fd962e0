#pragma once
// The options --robot, --controllers and --trajectory. They create a study, which is armtune's description
// of a tuning problem, from files that a robot's user already has: the arm, the ROS parameters of its
// controller, and motions.

#include "tuner/session/controller_study_session.hpp"

namespace CLI {
class App;
}

namespace armtune::internal::cli {

/// Adds the options. required: true if all three must be given; otherwise all three or none must be given.
void add_controller_study_options(CLI::App& command, ControllerStudyInputs& inputs, bool required);

/// Writes the study and prints the assumptions made; see make_controller_study. Returns the study's path;
/// empty if it was interrupted.
std::string write_study(const ControllerStudyInputs& inputs, const std::string& folder);

/// Calls write_study for a run. The study goes into the folder that study_folder_beside names. Returns what
/// write_study returns. The study of a resumed run exists already; then nothing is written, and its path is
/// returned.
std::string study_beside_run(const ControllerStudyInputs& inputs, RunPlace& place, bool several_ranks);

}  // namespace armtune::internal::cli
