#pragma once
// Gain sets side by side, scenario by scenario, from their errors.csv.

#include "tuner/report/csv_table.hpp"
#include "tuner/report/report_data.hpp"

namespace armtune::report {

/// One table per scenario, in the order of their first appearance; rows: the metrics that a person looks at
/// first, where any set has a value. errors: one per set, none where there is no file.
std::vector<Table> tables_of(const std::vector<std::optional<CsvTable>>& errors);

/// NaN where the table has no such row.
double value_of(const Table& table, Metric metric, std::size_t set);

}  // namespace armtune::report
