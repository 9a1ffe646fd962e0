#pragma once
// Writes the result files of `armtune yardstick`. That command compares the rollouts of a run with the best
// motions that the arm's limits allow.

#include <string>
#include <vector>

#include "tuner/cli/yardstick_measures.hpp"

namespace armtune::internal::cli {

struct YardstickRequest {
  std::string folder;                  ///< folder of a run, or of one of its gain sets
  std::vector<std::string> scenarios;  ///< names or files; empty: the run's own
  std::string out;                     ///< file to write instead of FOLDER/yardstick.csv; empty: none
  YardstickOptions options;
};

/// Throws InputError if `out` is given, and it or the provenance file beside it already exists.
void refuse_used_output(const YardstickRequest& request);

/// Writes the comparison as a CSV file, and beside it its provenance with the ending .yaml. Without `out`
/// they are yardstick.csv and yardstick.yaml in the folder; the run's columns.csv and its report are then
/// updated too. Returns the names of all files written, as "a, b". found: result of measure_rollouts.
/// seconds: wall time that measuring took. Throws InputError if a file cannot be written.
std::string write_yardstick(const YardstickRequest& request, const std::vector<Scenario>& scenarios,
                            const RolloutMeasures& found, double seconds);

}  // namespace armtune::internal::cli
