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

/// Returns a text table: per scenario one row per metric and one column per set, with ratios to the first set
/// beside the others.
std::string comparison_table(const std::vector<ComparedSet>& sets, const std::vector<Metric>& metrics);

/// Returns a long CSV: scenario,metric,unit,SET,...,SET/ratio,...
std::string comparison_csv(const std::vector<ComparedSet>& sets);

/// Returns the headline metrics, which a reader looks at first.
const std::vector<Metric>& headline_metrics();

}  // namespace armtune::internal
