// The sections with the analyses after a search: sensitivity and margins.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tuner/report/sections.hpp"

namespace armtune::internal::report {

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

namespace {

/// Returns, for example, "1.27"; "≥ 100" or "≤ 10" if no value failed; "none" if the nominal value fails.
std::string shown_margin(double nominal, double stands, double fails) {
  if (std::isnan(stands)) return "none";
  const char* bound = !std::isnan(fails) ? "" : stands < nominal ? "≤ " : "≥ ";
  return fmt::format("{}{:.4g}", bound, stands);
}

}  // namespace

std::vector<MarginRow> margins_of(const std::vector<std::optional<CsvTable>>& sets) {
  std::vector<MarginRow> rows;
  for (std::size_t set = 0; set < sets.size(); ++set) {
    if (!sets[set]) continue;
    const CsvTable& table = *sets[set];
    const std::size_t margin = table.column("margin");
    const std::size_t unit = table.column("unit");
    const std::size_t scenario = table.column("scenario");
    const std::size_t nominal = table.column("nominal");
    const std::size_t stands = table.column("stands");
    const std::size_t fails = table.column("fails");
    const std::size_t reason = table.column("reason");
    for (std::size_t r = 0; r < table.rows(); ++r) {
      const std::string what = table.text(r, margin);
      const std::string where = table.text(r, scenario);
      auto row = std::find_if(rows.begin(), rows.end(), [&](const MarginRow& other) {
        return other.margin == what && other.scenario == where;
      });
      if (row == rows.end()) {
        rows.push_back({what, table.text(r, unit), where, std::vector<double>(sets.size(), NAN),
                        std::vector<std::string>(sets.size()), std::vector<std::string>(sets.size())});
        row = rows.end() - 1;
      }
      row->values[set] = table.number(r, stands);
      row->text[set] = shown_margin(table.number(r, nominal), row->values[set], table.number(r, fails));
      row->reason[set] = table.text(r, reason);
    }
  }
  return rows;
}

}  // namespace armtune::internal::report
