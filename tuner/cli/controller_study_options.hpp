#pragma once
// --robot, --controllers, --trajectory: a study out of files that a robot's user has already.

#include "tuner/controller_study/controller_study.hpp"

namespace CLI {
class App;
}

namespace armtune::internal::cli {

/// Adds the options. required: the command can do nothing without them.
void add_controller_study_options(CLI::App& command, ControllerStudyInputs& inputs, bool required);

/// Writes the study and says what was assumed; see write_controller_study. Returns its path.
std::string make_controller_study(const ControllerStudyInputs& inputs, const std::string& folder);

}  // namespace armtune::internal::cli
