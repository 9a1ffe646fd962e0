#pragma once
// Adds the recorded rollouts of a run folder to its report page, as plots and 3D replays. To limit the size
// of the page, some recordings may be thinned or left out.

#include <string>

#include "tuner/report/report_data.hpp"
#include "tuner/report/scene.hpp"

namespace armtune::internal::report {

/// Returns the path of a gain set's file, relative to the run folder, such as "start/gains.yaml".
std::string name_in(const SceneSet& set, const std::string& file);

/// Adds plots and replays to `data.scenarios` from the files rollout_<scenario>.csv of every gain set. The
/// names of the scenarios must be set. room: bytes of text that plots and replays may take. If not all of
/// them fit, scenarios that failed or broke a limit of the arm with the last gain set have priority. Then
/// obstacles far from the tool are left out too. `data.thinned` lists all that is missing. `data.left_out`
/// lists the recordings that cannot be understood.
void add_recordings(const std::string& folder, const Scene& scene, std::size_t room, ReportData& data);

}  // namespace armtune::internal::report
