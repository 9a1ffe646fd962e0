#pragma once
// The interface through which a session compares rollouts with the best motions that the arm's limits allow
// (the yardstick). The comparison needs the trajectory planner, which armtune may be built without. Therefore
// the caller passes it to a session as a function.

#include <functional>
#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/rollout/error_report.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

struct YardstickFiles {
  std::vector<FurtherColumn> errors;  ///< the column reacquisition/limit
  std::vector<FileColumns> columns;   ///< columns of yardstick.csv
  std::vector<std::string> written;   ///< names of the files written
};

/// Compares the rollouts of a folder with their limits, writes yardstick.csv beside them, and returns the
/// columns for errors.csv, with one value per scenario. Never throws, because the run itself is finished.
using Yardstick =
    std::function<YardstickFiles(const std::string& folder, const std::vector<Scenario>& scenarios,
                                 const std::function<Gains(const Scenario&)>& gains)>;

}  // namespace armtune::internal
