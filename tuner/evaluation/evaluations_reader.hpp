#pragma once
// evaluations.csv read back.

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

/// Every whole row of a study's journal: a last one without its line end, of a run that was killed, is left
/// out, and those of candidates that were given up. Throws InputError naming file, line and column if it is
/// none of this study's or a number cannot be read.
std::vector<EvaluationRow> read_evaluations(const CsvTable& table, const Study& study);

}  // namespace armtune::internal
