#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tuner/report/tables.hpp"
#include "tuner/report/verdict.hpp"

namespace armtune::report {
namespace {

bool concerns(const std::vector<std::string>& scenarios, const std::string& name) {
  return scenarios.empty() || std::find(scenarios.begin(), scenarios.end(), name) != scenarios.end();
}

std::string violation(const Table& table, const StudyLimit& limit, std::size_t set) {
  if (set < table.status.size() && !table.status[set].empty() && table.status[set] != "completed") {
    return fmt::format("{}: {}", table.scenario, table.status[set]);
  }
  const double value = value_of(table, limit.metric, set);
  const double bound = limit.value ? *limit.value : value_of(table, limit.metric, 0);
  if (std::isnan(value) || std::isnan(bound)) return {};  // the metric does not apply here
  const bool kept = limit.upper ? value <= bound : value >= bound;
  if (kept) return {};
  return fmt::format("{} is {:.4g} in {}; its limit is at {} {:.4g}", name(limit.metric), value,
                     table.scenario, limit.upper ? "most" : "least", bound);
}

}  // namespace

double Change::worsening() const {
  return larger_is_better(metric) ? 1.0 / ratio : ratio;
}

std::vector<Change> changes(const std::vector<Table>& tables, const std::vector<StudyTerm>& terms,
                            std::size_t set) {
  std::vector<Change> found;
  for (const StudyTerm& term : terms) {
    double sum = 0.0;
    int count = 0;
    for (const Table& table : tables) {
      if (!concerns(term.scenarios, table.scenario)) continue;
      const double before = value_of(table, term.metric, 0);
      const double after = value_of(table, term.metric, set);
      if (!(before > 0.0) || !(after > 0.0)) continue;
      sum += std::log(after / before);
      ++count;
    }
    if (count > 0) found.push_back({term.metric, std::exp(sum / count)});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Change& a, const Change& b) { return a.worsening() < b.worsening(); });
  return found;
}

std::string closest_joint(const std::vector<Table>& tables, std::size_t set) {
  double largest = -1.0;
  std::string text;
  for (const Table& table : tables) {
    for (const MetricRow& row : table.rows) {
      if (row.metric != Metric::kJointVelocityMaxRatio || set >= row.values.size()) continue;
      if (!(row.values[set] > largest)) continue;
      largest = row.values[set];
      // "JOINT at TIME s"
      const std::string& where = set < row.text.size() ? row.text[set] : std::string();
      const std::size_t at = where.find(" at ");
      text = fmt::format("{} {}, {:.0f} %{} in {}", at == std::string::npos ? where : where.substr(0, at),
                         largest > 1.0 ? "breaks its velocity limit" : "comes closest to its velocity limit",
                         100.0 * largest, at == std::string::npos ? std::string() : where.substr(at),
                         table.scenario);
    }
  }
  return text;
}

std::vector<std::string> violations(const std::vector<Table>& tables, const std::vector<StudyLimit>& limits,
                                    std::size_t set) {
  std::vector<std::string> found;
  for (const Table& table : tables) {
    for (const StudyLimit& limit : limits) {
      if (!concerns(limit.scenarios, table.scenario)) continue;
      std::string text = violation(table, limit, set);
      if (!text.empty() && std::find(found.begin(), found.end(), text) == found.end()) {
        found.push_back(std::move(text));
      }
    }
  }
  return found;
}

}  // namespace armtune::report
