#pragma once
// A front as files and text.

#include <string>

#include "sim/rollout/columns.hpp"
#include "tuner/trade_off/pareto.hpp"

namespace armtune::internal {

/// Name, unit and meaning of pareto.csv's columns.
std::vector<Column> pareto_columns(const Study& study, const ParetoOptions& options);

/// pareto.csv: a row per point of the front, then the start's, with criteria and gains. Numbers read back to
/// the same bits.
std::string pareto_csv(const Study& study, const ParetoOptions& options, const ParetoResult& result);

/// For terminals: the best point under each level, the start among them, what dominates it, hypervolume.
std::string pareto_table(const Study& study, const ParetoOptions& options, const ParetoResult& result);

/// File of a point's gains inside the run's folder: "points/07.yaml".
std::string point_file(std::size_t point);

}  // namespace armtune::internal
