#include "tuner/report/findings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "tuner/report/tables.hpp"

namespace armtune::internal::report {
namespace {

bool concerns(const std::vector<std::string>& scenarios, const std::string& name) {
  return scenarios.empty() || std::find(scenarios.begin(), scenarios.end(), name) != scenarios.end();
}

bool failed(const Table& table, std::size_t set) {
  return set < table.status.size() && !table.status[set].empty() && table.status[set] != "completed";
}

/// Returns both numbers with as many digits as are needed to tell them apart.
std::pair<std::string, std::string> told_apart(double a, double b) {
  constexpr int kDigits[] = {4, 6, 9, 17};
  std::pair<std::string, std::string> texts;
  for (const int digits : kDigits) {
    texts = {fmt::format("{:.{}g}", a, digits), fmt::format("{:.{}g}", b, digits)};
    if (texts.first != texts.second) break;
  }
  return texts;
}

std::string violation(const Table& table, const StudyLimit& limit, std::size_t set) {
  const double value = value_of(table, limit.metric, set);
  const double bound = limit.value ? *limit.value : value_of(table, limit.metric, 0);
  if (std::isnan(value) || std::isnan(bound)) return {};  // the metric does not apply here
  const bool kept = limit.upper ? value <= bound : value >= bound;
  if (kept) return {};
  const auto [is, allowed] = told_apart(value, bound);
  return fmt::format("{} is {} in {} (must be at {} {})", name(limit.metric), is, table.scenario,
                     limit.upper ? "most" : "least", allowed);
}

}  // namespace

double Change::worsening() const {
  return larger_is_better(metric) ? 1.0 / ratio : ratio;
}

std::vector<Change> changes(const std::vector<Table>& tables, const std::vector<StudyTerm>& terms,
                            std::size_t set) {
  std::vector<Change> found;
  for (const StudyTerm& term : terms) {
    Change change;
    change.metric = term.metric;
    double sum = 0.0;
    for (const Table& table : tables) {
      if (!concerns(term.scenarios, table.scenario)) continue;
      const double before = value_of(table, term.metric, 0);
      const double after = value_of(table, term.metric, set);
      if (!(before > 0.0) || !(after > 0.0)) continue;
      sum += std::log(after / before);
      change.scenarios.push_back(table.scenario);
    }
    if (change.scenarios.empty()) continue;
    change.ratio = std::exp(sum / static_cast<double>(change.scenarios.size()));
    found.push_back(std::move(change));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Change& a, const Change& b) { return a.worsening() < b.worsening(); });
  return found;
}

std::optional<Step> worst_step(const std::vector<Table>& tables, const std::vector<Metric>& metrics,
                               std::size_t set) {
  std::optional<Step> worst;
  double worst_ratio = 1.0;
  for (const Table& table : tables) {
    for (const Metric metric : metrics) {
      const double before = value_of(table, metric, 0);
      const double after = value_of(table, metric, set);
      if (!(before > 0.0) || !(after > 0.0)) continue;
      const double ratio = larger_is_better(metric) ? before / after : after / before;
      if (ratio <= worst_ratio) continue;
      worst_ratio = ratio;
      worst = {metric, table.scenario, before, after};
    }
  }
  return worst;
}

std::string closest_joint(const std::vector<Table>& tables, std::size_t set) {
  double largest = -1.0;
  std::string text;
  for (const Table& table : tables) {
    for (const MetricRow& row : table.rows) {
      if (row.metric != Metric::kJointVelocityMaxRatio || set >= row.values.size()) continue;
      if (!(row.values[set] > largest)) continue;
      largest = row.values[set];
      const Place place = set < row.places.size() ? row.places[set] : Place();
      const std::string percent =
          largest > 1.0 ? told_apart(100.0 * largest, 100.0).first : fmt::format("{:.0f}", 100.0 * largest);
      text = fmt::format("{} {}, {} %{} in {}", place.joint.empty() ? "a joint" : place.joint,
                         largest > 1.0 ? "breaks its velocity limit" : "comes closest to its velocity limit",
                         percent, place.when, table.scenario);
    }
  }
  return text;
}

std::vector<std::string> failures(const std::vector<Table>& tables, std::size_t set) {
  std::vector<std::string> found;
  for (const Table& table : tables) {
    if (!failed(table, set)) continue;
    const bool told = set < table.reason.size() && !table.reason[set].empty();
    found.push_back(fmt::format("{}: {}", table.scenario, told ? table.reason[set] : table.status[set]));
  }
  return found;
}

std::vector<std::string> violations(const std::vector<Table>& tables, const std::vector<StudyLimit>& limits,
                                    std::size_t set) {
  std::vector<std::string> found;
  for (const Table& table : tables) {
    if (failed(table, set)) continue;
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

std::vector<StudyLimit> limits_of_arm() {
  return {{Metric::kJointVelocityMaxRatio, true, 1.0, {}},
          {Metric::kJointPositionMinMargin, false, 0.0, {}},
          {Metric::kJointEffortMaxRatio, true, 1.0, {}},
          {Metric::kJointAccelerationMaxRatio, true, 1.0, {}}};
}

std::vector<std::string> wrong_with(const std::vector<Table>& tables, const std::vector<StudyLimit>& limits,
                                    std::size_t set) {
  std::vector<std::string> lines = failures(tables, set);
  for (std::string& line : violations(tables, limits, set)) lines.push_back(std::move(line));
  return lines;
}

std::vector<std::string> beyond_arm(const std::vector<Table>& tables, const std::vector<StudyLimit>& asked,
                                    std::size_t set) {
  std::vector<std::string> lines;
  for (const Table& table : tables) {
    for (const StudyLimit& limit : limits_of_arm()) {
      std::vector<StudyLimit> same = asked;
      std::erase_if(same, [&limit](const StudyLimit& other) { return other.metric != limit.metric; });
      if (!violations({table}, same, set).empty()) continue;  // told already
      for (std::string& line : violations({table}, {limit}, set)) lines.push_back(std::move(line));
    }
  }
  return lines;
}

}  // namespace armtune::internal::report
