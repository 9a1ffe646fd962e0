// What comes after a search: sensitivity and margins.

#include <algorithm>
#include <cmath>

#include "tuner/report/sections.hpp"

namespace armtune::report {

std::vector<Sensitivity> sensitivity_of(const CsvTable& table) {
  const std::size_t gain = table.column("gain");
  const std::size_t importance = table.column("importance");
  const std::size_t local = table.column("local");
  const std::size_t elasticity = table.column("elasticity");
  const std::size_t correlation = table.column("rank_correlation");
  std::vector<Sensitivity> rows;
  rows.reserve(table.rows());
  for (std::size_t r = 0; r < table.rows(); ++r) {
    rows.push_back({table.text(r, gain), table.number(r, importance), table.number(r, local),
                    table.number(r, elasticity), table.number(r, correlation)});
  }
  return rows;
}

std::vector<MarginRow> margins_of(const std::vector<std::optional<CsvTable>>& sets) {
  std::vector<MarginRow> rows;
  for (std::size_t set = 0; set < sets.size(); ++set) {
    if (!sets[set]) continue;
    const CsvTable& table = *sets[set];
    const std::size_t margin = table.column("margin");
    const std::size_t unit = table.column("unit");
    const std::size_t scenario = table.column("scenario");
    const std::size_t stands = table.column("stands");
    const std::size_t reason = table.column("reason");
    for (std::size_t r = 0; r < table.rows(); ++r) {
      const std::string what = table.text(r, margin);
      const std::string where = table.text(r, scenario);
      auto row = std::find_if(rows.begin(), rows.end(), [&](const MarginRow& other) {
        return other.margin == what && other.scenario == where;
      });
      if (row == rows.end()) {
        rows.push_back({what, table.text(r, unit), where, std::vector<double>(sets.size(), NAN),
                        std::vector<std::string>(sets.size())});
        row = rows.end() - 1;
      }
      row->values[set] = table.number(r, stands);
      row->reason[set] = table.text(r, reason);
    }
  }
  return rows;
}

}  // namespace armtune::report
