#pragma once
// The recordings of a run folder on its page: as many of them, and each as fine, as there is room for.

#include <string>

#include "tuner/report/report_data.hpp"
#include "tuner/report/scene.hpp"

namespace armtune::internal::report {

/// Name of a file of a set below the run's folder: "start/gains.yaml".
std::string name_in(const SceneSet& set, const std::string& file);

/// Adds plots and replays of `data.scenarios`, whose names are known, from the rollout_<scenario>.csv of
/// every set. room: bytes of text that they may take. Where all do not fit, those scenarios come first that
/// failed or broke a limit of the arm with the last set, and obstacles far from the tool are left out;
/// `data.thinned` says so. A recording that cannot be understood is named in `data.left_out`.
void add_recordings(const std::string& folder, const Scene& scene, std::size_t room, ReportData& data);

}  // namespace armtune::internal::report
