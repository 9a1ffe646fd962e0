#include "tuner/evaluation/evaluations_reader.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armtune/error.hpp"
#include "core/common/input_place.hpp"
#include "core/common/message_text.hpp"

namespace armtune::internal {
namespace {

std::size_t column(const CsvTable& table, const std::string& name, const Study& study) {
  if (const auto found = table.find(name)) return *found;
  throw InputError(
      at_line(table.name(), 1, name),
      fmt::format("there is no column '{}', but the evaluations of {} have one; give the evaluations "
                  "file of this study",
                  name, study.source))
      .with_value({}, fmt::format("a column '{}'", name));
}

double finite(const CsvTable& table, std::size_t row, std::size_t column) {
  const double value = table.number(row, column);
  if (std::isfinite(value)) return value;
  const std::string text = table.text(row, column);
  throw InputError(at_line(table.name(), row + 2, table.header()[column]),
                   fmt::format("{} in the column '{}' is not a finite number",
                               text.empty() ? "an empty cell" : shown(text), table.header()[column]))
      .with_value(text, "a finite number");
}

}  // namespace

std::vector<EvaluationRow> read_evaluations(const CsvTable& table, const Study& study) {
  const std::size_t objective = column(table, "objective", study);
  const std::size_t violation = column(table, "violation", study);
  std::vector<std::size_t> parameters;
  parameters.reserve(study.space.free.size());
  for (const Parameter& p : study.space.free) parameters.push_back(column(table, p.entry.name, study));

  std::vector<EvaluationRow> rows;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.text(row, objective).empty()) continue;  // an abandoned evaluation of an earlier version
    Gains gains = study.space.start;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      value(gains, study.space.free[i].entry) = finite(table, row, parameters[i]);
    }
    rows.push_back(
        {study.space.point_of(gains), finite(table, row, objective), finite(table, row, violation)});
  }
  return rows;
}

}  // namespace armtune::internal
