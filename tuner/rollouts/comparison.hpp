#pragma once
// Tables that put several gain sets side by side, with ratios against the first.

#include <string>
#include <vector>

#include "sim/rollout/error_report.hpp"

namespace armtune::internal {

struct ComparedSet {
  std::string name;
  std::vector<ScenarioResult> results;  ///< same scenarios in the same order in every set
};

/// Text table: per scenario one row per metric, one column per set, ratios against the first set beside the
/// others.
std::string comparison_table(const std::vector<ComparedSet>& sets, const std::vector<Metric>& metrics);

/// Long CSV: scenario,metric,unit,SET,...,SET/ratio,...
std::string comparison_csv(const std::vector<ComparedSet>& sets);

/// The metrics a person looks at first.
const std::vector<Metric>& headline_metrics();

}  // namespace armtune::internal
