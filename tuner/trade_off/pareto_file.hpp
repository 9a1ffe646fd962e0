#pragma once
// Formats a Pareto front as the file pareto.csv and as a table for the terminal.

#include <string>

#include "sim/rollout/columns.hpp"
#include "tuner/trade_off/pareto.hpp"

namespace armtune::internal {

/// Returns name, unit and meaning of the columns of pareto.csv.
std::vector<Column> pareto_columns(const Study& study, const ParetoOptions& options);

/// Returns the text of pareto.csv: one row per point of the front, then one for the start gains. Each row has
/// the criteria and the gains. Numbers have all digits that are needed to read back the same value.
std::string pareto_csv(const Study& study, const ParetoOptions& options, const ParetoResult& result);

/// Returns a table for terminals. It shows the best point of each level, the two ends of the front, and the
/// start gains. Lines below the table give the number of points that dominate the start gains, and the
/// hypervolume.
std::string pareto_table(const Study& study, const ParetoOptions& options, const ParetoResult& result);

/// Returns the name of the file with a point's gains, below the run's folder: "points/07.yaml".
std::string point_file(std::size_t point);

}  // namespace armtune::internal
