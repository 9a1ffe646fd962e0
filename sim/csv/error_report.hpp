#pragma once
// errors.csv: one row per scenario, every metric; columns.csv: what every column means.

#include <string>
#include <vector>

#include "sim/rollout/columns.hpp"
#include "sim/rollout/rollout.hpp"

namespace armtune {

struct ScenarioResult {
  std::string scenario;
  RolloutResult result;
};

/// Text of errors.csv. Numbers read back to the same bits; metrics without a value are empty cells.
std::string errors_csv(const std::vector<ScenarioResult>& results);

/// Text of columns.csv for errors.csv, the rollout files' columns and, where given, evaluations.csv's.
std::string columns_csv(const std::vector<Column>& rollout_columns,
                        const std::vector<Column>& journal_columns = {});

}  // namespace armtune
