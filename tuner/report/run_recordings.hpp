#pragma once
// Adds the recorded rollouts of a run folder to its report page, as plots and 3D replays. To limit the size
// of the page, some recordings may be thinned or left out.

#include <string>

#include "tuner/report/report_data.hpp"
#include "tuner/report/scene.hpp"

namespace armtune::internal::report {

/// Returns the name of a gain set's file below the run's folder, such as "start/gains.yaml".
std::string name_in(const SceneSet& set, const std::string& file);

/// Adds plots and replays of `data.scenarios`, whose names must be set, from the rollout_<scenario>.csv files
/// of every set. room: bytes of text that they may take. If they do not all fit, scenarios that failed or
/// broke a limit of the arm with the last set come first, obstacles far from the tool are left out, and
/// `data.thinned` lists what is missing. A recording that cannot be understood is named in `data.left_out`.
void add_recordings(const std::string& folder, const Scene& scene, std::size_t room, ReportData& data);

}  // namespace armtune::internal::report
