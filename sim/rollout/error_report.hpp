#pragma once
// errors.csv: one row per scenario, every metric; columns.csv: what every column means.

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
  std::vector<BrokenLimit> broken = {};  ///< limits of the arm that were passed, the earliest first
  LeastClearances nearest = {};          ///< of a scenario with a cell, whose clearance model it refers to
  std::optional<Shake> shake = {};       ///< the first joint whose torque swings to and fro
};

/// A column of errors.csv that is no metric of the rollout itself.
struct FurtherColumn {
  Column column;
  std::vector<double> values;  ///< one per result; NaN where there is none
};

/// Text of errors.csv. Numbers read back to the same bits; metrics without a value are empty cells. further:
/// columns behind the metrics, in order.
std::string errors_csv(const std::vector<ScenarioResult>& results,
                       const std::vector<FurtherColumn>& further = {});

/// Name, unit and meaning of the columns of errors.csv.
std::vector<Column> error_columns(const std::vector<FurtherColumn>& further = {});

/// The columns of one CSV file of a run.
struct FileColumns {
  std::string file;
  std::vector<Column> columns;
};

/// Text of columns.csv: file,name,unit,meaning.
std::string columns_csv(const std::vector<FileColumns>& files);

}  // namespace armtune::internal
