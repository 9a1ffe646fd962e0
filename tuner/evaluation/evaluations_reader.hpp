#pragma once
// Reads evaluations.csv back.

#include <string>
#include <vector>

#include "sim/csv/csv_table.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {

struct EvaluationRow {
  std::vector<double> x;  ///< search coordinates
  double objective = 0.0;
  double violation = 0.0;
};

/// Returns every whole row of a study's evaluations.csv. Rows of candidates that an earlier version abandoned
/// are left out. The table itself leaves out a last row without its line end, which a killed run leaves.
/// Throws InputError naming file, line and column if the table is not of this study or a number cannot be
/// read.
std::vector<EvaluationRow> read_evaluations(const CsvTable& table, const Study& study);

}  // namespace armtune::internal
