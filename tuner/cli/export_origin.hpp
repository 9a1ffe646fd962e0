#pragma once
// Finds the arm that a set of gains is for, and describes where the gains come from. `armtune export` needs
// both to write gains in a robot's file format.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/robot/robot_model.hpp"

namespace armtune::internal::cli {

struct GainsToExport {
  std::string set;    ///< run folder, gains file or bundled gains
  std::string robot;  ///< the robot that the user named; empty: none
};

/// Returns the arm that the gains are for: the arm that the user named, else the arm of the run's study, else
/// the UR10. run: the folder that the gains are in, or empty. Throws InputError for a run without a study,
/// because nothing in it names the arm.
std::shared_ptr<const RobotModel> robot_of(const GainsToExport& what, const std::string& run);

/// Returns the origin of the gains at `path`, as pairs (key, value in words). Results of the run, such as its
/// objective, are included only if they apply to these gains on this arm. robot: path of the arm's file.
std::vector<std::pair<std::string, std::string>> origin_of(const GainsToExport& what, const std::string& path,
                                                           const std::string& run, const std::string& robot);

/// Prints a warning if the gains at `path` are the final gains of a run that failed a simulation check. run:
/// the folder that the gains are in, or empty.
void warn_of_failed_checks(const std::string& path, const std::string& run);

}  // namespace armtune::internal::cli
