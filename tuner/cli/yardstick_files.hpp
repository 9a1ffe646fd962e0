#pragma once
// What armtune yardstick writes.

#include <string>
#include <vector>

#include "tuner/cli/yardstick_measures.hpp"

namespace armtune::internal::cli {

struct YardstickRequest {
  std::string folder;                  ///< of a run, or of one of its gain sets
  std::vector<std::string> scenarios;  ///< names or files; empty: the run's own
  std::string out;                     ///< file in place of FOLDER/yardstick.csv; empty: that
  YardstickOptions options;
};

/// Throws InputError if a file that is asked for in place of the run's own is there already.
void refuse_used_output(const YardstickRequest& request);

/// Writes yardstick.csv and where it came from, and makes the run's own report anew. Returns their names, as
/// "a, b". seconds: that measuring took. Throws InputError if a file cannot be written.
std::string write_yardstick(const YardstickRequest& request, const std::vector<Scenario>& scenarios,
                            const RolloutMeasures& found, double seconds);

}  // namespace armtune::internal::cli
