#pragma once
// Reads the evaluations of a search back from its table evaluations.csv. `armtune sensitivity` uses them.

#include <string>
#include <vector>

#include "sim/csv/csv_table.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {

struct EvaluationRow {
  std::vector<double> x;  ///< search coordinates of the gains (ParameterSpace)
  double objective = 0.0;
  double violation = 0.0;
};

/// Returns every complete row of a study's evaluations.csv. Rows without an objective are left out; an
/// earlier version of armtune wrote them for abandoned candidates. CsvTable has already removed a last row
/// without a line end, which a killed run can leave in the file. Throws InputError naming file, line and
/// column if the table is not of this study or a number cannot be read.
std::vector<EvaluationRow> read_evaluations(const CsvTable& table, const Study& study);

}  // namespace armtune::internal
