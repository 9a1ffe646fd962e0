#pragma once
// A rollout's CSV as plots and a replay show it.

#include "sim/csv/csv_table.hpp"
#include "tuner/report/report_data.hpp"
#include "tuner/report/scene.hpp"

namespace armtune::report {

/// How fine: what one run may take of the page's size.
struct Resolution {
  std::size_t buckets = 700;  ///< of each plot's column, two values each
  double replay_rate = 25.0;  ///< [Hz]
};

/// A resolution at which `runs` recordings of `columns` columns and `seconds` in all stay below `bytes` of
/// text.
Resolution resolution_for(std::size_t runs, std::size_t columns, double seconds, std::size_t bytes);

/// Names of the joints in the order of a recording's columns.
std::vector<std::string> joints_of(const CsvTable& rollout);

/// Plots, states, slerps, end and replay; set, status and reason are the caller's. scenario, arm: null where
/// the run folder has no scene; then without torques over their limits, and without a replay. Throws
/// InputError naming the file if a column is missing.
Run run_of(const CsvTable& rollout, const SceneScenario* scenario, const Arm* arm,
           const Resolution& resolution);

}  // namespace armtune::report
