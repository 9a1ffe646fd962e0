#pragma once
// Tables that compare gain sets scenario by scenario, read from their errors.csv.

#include "sim/csv/csv_table.hpp"
#include "tuner/report/report_data.hpp"

namespace armtune::internal::report {

/// Returns one table per scenario, in the order of their first appearance. A table has a row for each metric
/// that has a value in at least one set, headline metrics first. errors: one per set, empty if there is no
/// file.
std::vector<Table> tables_of(const std::vector<std::optional<CsvTable>>& errors);

/// Keeps the rows of headline metrics and of `wanted`.
void keep_rows(std::vector<Table>& tables, const std::vector<Metric>& wanted);

/// Returns the value of a metric, or NaN if the table has no such row.
double value_of(const Table& table, Metric metric, std::size_t set);

}  // namespace armtune::internal::report
