#pragma once
// Writes the texts of a controller study (controller_study.hpp): study.yaml, and a scenario for each motion.

#include <string>
#include <vector>

#include "tuner/controller_study/controller_in_file.hpp"
#include "tuner/controller_study/controller_study.hpp"
#include "tuner/controller_study/study_arm.hpp"
#include "tuner/controller_study/study_motions.hpp"

namespace armtune::internal {

/// Name of the file with the start gains, if there is no parameter file.
inline constexpr const char* kStartGainsFile = "gains.yaml";

/// Returns the text of the scenario for a motion. period: control period [s].
std::string scenario_yaml(const StudyMotion& move, const StudyArm& arm, const ControllerStudyInputs& inputs,
                          const ControllerInFile& from, double period);

/// Returns the text of study.yaml. controller: its name. parameters: lines that list the gains to tune
/// (tuned_parameters).
std::string controller_study_yaml(const std::vector<StudyMotion>& moves, const StudyArm& arm,
                                  const ControllerStudyInputs& inputs, const std::string& controller,
                                  const std::string& parameters);

}  // namespace armtune::internal
