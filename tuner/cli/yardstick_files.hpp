#pragma once
// The files that `armtune yardstick` writes.

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

/// Throws InputError if `out` is given and already exists.
void refuse_used_output(const YardstickRequest& request);

/// Writes yardstick.csv and its provenance, and rewrites the run's report. Returns their names, as "a, b".
/// seconds: wall time that measuring took. Throws InputError if a file cannot be written.
std::string write_yardstick(const YardstickRequest& request, const std::vector<Scenario>& scenarios,
                            const RolloutMeasures& found, double seconds);

}  // namespace armtune::internal::cli
