#pragma once
// Generates two result files of a run: errors.csv, with one row per scenario and every metric, and
// columns.csv, with the unit and meaning of every column.

#include <optional>
#include <string>
#include <vector>

#include "sim/rollout/columns.hpp"
#include "sim/rollout/limit_watch.hpp"
#include "sim/rollout/rollout.hpp"
#include "sim/rollout/shake_watch.hpp"

namespace armtune::internal {

struct ScenarioResult {
  std::string scenario;
  RolloutResult result;
  std::vector<BrokenLimit> broken = {};  ///< limits of the arm that were exceeded, the earliest first
  LeastClearances nearest = {};          ///< smallest distances; refers to the scenario's clearance model
  std::optional<Shake> shake = {};       ///< the first joint whose torque oscillates
};

/// A column of errors.csv that is not a metric of the rollout itself.
struct FurtherColumn {
  Column column;
  std::vector<double> values;  ///< one per result; NaN for a result without a value
};

/// Returns the text of errors.csv. Numbers read back to the same bits. Metrics without a value are empty
/// cells. further: columns to add after the metrics, in order.
std::string errors_csv(const std::vector<ScenarioResult>& results,
                       const std::vector<FurtherColumn>& further = {});

/// Returns name, unit and meaning of the columns of errors.csv.
std::vector<Column> error_columns(const std::vector<FurtherColumn>& further = {});

/// The columns of one CSV file of a run.
struct FileColumns {
  std::string file;
  std::vector<Column> columns;
};

/// Returns the text of columns.csv: file,name,unit,meaning.
std::string columns_csv(const std::vector<FileColumns>& files);

}  // namespace armtune::internal
