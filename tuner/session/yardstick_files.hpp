#pragma once
// The interface through which a session compares rollouts with the yardstick, that is, with the best motions
// that the arm's limits allow. The comparison needs the trajectory planner, and armtune can be built without
// it. Therefore the caller passes the comparison to a session as a function.

#include <functional>
#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/rollout/error_report.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

struct YardstickFiles {
  std::vector<FurtherColumn> errors;  ///< for errors.csv: the column `reacquisition/limit`
  std::vector<FileColumns> columns;   ///< descriptions of the columns of yardstick.csv
  std::vector<std::string> written;   ///< names of the files written
};

/// A function that compares the recorded rollouts in `folder` with the best possible motions. It writes
/// yardstick.csv into the folder, and returns a further column for errors.csv with one value per scenario. It
/// never throws, because the run itself is finished.
using Yardstick =
    std::function<YardstickFiles(const std::string& folder, const std::vector<Scenario>& scenarios,
                                 const std::function<Gains(const Scenario&)>& gains)>;

}  // namespace armtune::internal
