#pragma once
// Tables that compare several gain sets side by side, with ratios to the first set.

#include <string>
#include <vector>

#include "sim/rollout/error_report.hpp"

namespace armtune::internal {

struct ComparedSet {
  std::string name;
  std::vector<ScenarioResult> results;  ///< the same scenarios in the same order in every set
};

/// Returns a table for terminals. It has a block for each scenario, with one row per metric and one column
/// per gain set. For every set after the first, a further column gives the ratio of its value to that of the
/// first set.
std::string comparison_table(const std::vector<ComparedSet>& sets, const std::vector<Metric>& metrics);

/// Returns the text of comparison.csv, with one row per scenario and metric. The columns are
/// scenario,metric,unit, then SET for each gain set, then SET/ratio for each set but the first. The slash is
/// part of the column's name.
std::string comparison_csv(const std::vector<ComparedSet>& sets);

/// Returns the headline metrics. These are the most important metrics, which tables show first.
const std::vector<Metric>& headline_metrics();

}  // namespace armtune::internal
