#pragma once
// Tables that compare the metrics of gain sets, one table for each scenario. They are made from the file
// errors.csv of each set.

#include "sim/csv/csv_table.hpp"
#include "tuner/report/report_data.hpp"

namespace armtune::internal::report {

/// Returns one table per scenario, in the order of their first appearance. A table has a row for each metric
/// that has a value in at least one set. Headline metrics (comparison.hpp) come first. errors: the table
/// errors.csv of each set, empty if the file is missing.
std::vector<Table> tables_of(const std::vector<std::optional<CsvTable>>& errors);

/// Removes all rows except those of headline metrics and of the metrics in `wanted`.
void keep_rows(std::vector<Table>& tables, const std::vector<Metric>& wanted);

/// Returns the value of a metric, or NaN if the table has no such row.
double value_of(const Table& table, Metric metric, std::size_t set);

}  // namespace armtune::internal::report
