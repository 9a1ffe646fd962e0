#pragma once
// What the best that an arm's limits allow adds to a run's files. Measuring it takes the planner, which may
// be left out of armtune: whoever has it hands it to a session as a function.

#include <functional>
#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/rollout/error_report.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

struct YardstickFiles {
  std::vector<FurtherColumn> errors;  ///< reacquisition/limit
  std::vector<FileColumns> columns;   ///< of yardstick.csv
  std::vector<std::string> written;   ///< names
};

/// Compares the rollouts of a folder with their limits, leaves yardstick.csv beside them, and returns the
/// columns for errors.csv, a value for each of the scenarios. Never throws: the run itself is finished.
using Yardstick =
    std::function<YardstickFiles(const std::string& folder, const std::vector<Scenario>& scenarios,
                                 const std::function<Gains(const Scenario&)>& gains)>;

}  // namespace armtune::internal
