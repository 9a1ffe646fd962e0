#include "tuner/journal/evaluations_reader.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/common/error.hpp"
#include "sim/csv/csv_table.hpp"

namespace armtune {
namespace {

std::size_t column(const CsvTable& table, const std::string& path, const std::string& name,
                   const Study& study) {
  if (const auto found = table.find(name)) return *found;
  throw InputError(
      fmt::format("{}:1: no column '{}', which evaluations of {} have", path, name, study.source));
}

double finite(const CsvTable& table, std::size_t row, std::size_t column, const std::string& path) {
  const double value = table.number(row, column);
  if (std::isfinite(value)) return value;
  throw InputError(fmt::format("{}:{}: '{}' in column {} is no finite number", path, row + 2,
                               table.text(row, column), table.header()[column]));
}

}  // namespace

std::vector<EvaluationRow> read_evaluations(const std::string& path, const Study& study) {
  const CsvTable table = CsvTable::read(path);
  const std::size_t objective = column(table, path, "objective", study);
  const std::size_t violation = column(table, path, "violation", study);
  std::vector<std::size_t> parameters;
  parameters.reserve(study.space.free.size());
  for (const Parameter& p : study.space.free) parameters.push_back(column(table, path, p.entry.name, study));

  std::vector<EvaluationRow> rows;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.text(row, objective).empty()) continue;  // an earlier version gave it up
    Gains gains = study.space.start;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      value(gains, study.space.free[i].entry) = finite(table, row, parameters[i], path);
    }
    rows.push_back({study.space.point_of(gains), finite(table, row, objective, path),
                    finite(table, row, violation, path)});
  }
  return rows;
}

}  // namespace armtune
