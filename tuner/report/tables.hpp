#pragma once
// Gain sets side by side, scenario by scenario, from their errors.csv.

#include "sim/csv/csv_table.hpp"
#include "tuner/report/report_data.hpp"

namespace armtune::internal::report {

/// One table per scenario, in the order of their first appearance; rows: every metric of which any set has a
/// value, those first that a person looks at first. errors: one per set, none where there is no file.
std::vector<Table> tables_of(const std::vector<std::optional<CsvTable>>& errors);

/// Leaves the rows that a person looks at first, and those of `wanted`.
void keep_rows(std::vector<Table>& tables, const std::vector<Metric>& wanted);

/// NaN where the table has no such row.
double value_of(const Table& table, Metric metric, std::size_t set);

}  // namespace armtune::internal::report
