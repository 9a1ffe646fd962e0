#pragma once
// --yardstick: what the arm's limits would allow, at the end of a run.

#include <functional>
#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/rollout/error_report.hpp"
#include "sim/scenario/scenario.hpp"

namespace CLI {
class App;
}

namespace armtune::cli {

/// Adds --yardstick where armtune was built with the planner; elsewhere nothing, and `wanted` stays false.
void add_yardstick_option(CLI::App& command, bool& wanted);

/// What the yardstick of one gain set adds to the run's files.
struct YardstickFiles {
  std::vector<FurtherColumn> errors;  ///< reacquisition/limit
  std::vector<FileColumns> columns;   ///< of yardstick.csv
  std::string written;                ///< ", yardstick.csv"
};

/// Holds the rollouts of a folder against their limits, leaves yardstick.csv beside them, and returns the
/// columns for errors.csv, a value for each of the scenarios. Never throws: the run itself is finished, and
/// what went wrong is told on stderr. Nothing is left of an interrupted one but yardstick.csv with what is
/// finished.
YardstickFiles write_yardstick(const std::string& folder, const std::vector<Scenario>& scenarios,
                               const std::function<Gains(const Scenario&)>& gains);

}  // namespace armtune::cli
