#pragma once
// Which arm exported gains are for, and where they came from.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/robot/robot_model.hpp"

namespace armtune::internal::cli {

struct GainsToExport {
  std::string set;    ///< run folder, gains file or bundled gains
  std::string robot;  ///< as it was asked for; empty: it was not
};

/// The arm that the gains are for: the one asked for; else that of the run's study; else the UR10. run: the
/// folder that they are in, or empty. Throws InputError for a run without a study, which does not say which
/// arm it is of.
std::shared_ptr<const RobotModel> robot_of(const GainsToExport& what, const std::string& run);

/// Where the gains at `path` came from, as (what, that in words); figures only where they are these gains' on
/// this arm. robot: its file.
std::vector<std::pair<std::string, std::string>> origin_of(const GainsToExport& what, const std::string& path,
                                                           const std::string& run, const std::string& robot);

}  // namespace armtune::internal::cli
