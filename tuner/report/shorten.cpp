#include "tuner/report/shorten.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tuner/report/telling.hpp"

namespace armtune::internal::report {
namespace {

/// Keeps the first `most` items, and adds the number of the others to `data.thinned`. what: name of the
/// items.
template <typename Item>
void keep_first(std::vector<Item>& items, std::size_t most, const char* what, ReportData& data) {
  if (items.size() <= most) return;
  data.thinned.push_back(fmt::format("{} of {} {}", items.size() - most, items.size(), what));
  items.resize(most);
}

/// Returns roughly the bytes of a table's text.
std::size_t bytes_of(const Table& table) {
  constexpr std::size_t kOfRow = 260;  // names, words and meaning of the metric
  constexpr std::size_t kOfValue = 22;
  std::size_t bytes = table.scenario.size() + 100;
  for (const MetricRow& row : table.rows) {
    bytes += kOfRow + kOfValue * row.values.size();
    for (const std::string& text : row.text) bytes += text.size() + 3;
  }
  for (const auto* texts : {&table.status, &table.reason}) {
    for (const std::string& text : *texts) bytes += text.size() + 3;
  }
  return bytes;
}

/// Keeps the tables of the first scenarios in telling_order(), in the original order of the tables.
void shorten_tables(std::vector<Table>& tables, std::size_t most_bytes, std::size_t set, const char* file,
                    ReportData& data) {
  std::vector<std::string> names;
  names.reserve(tables.size());
  for (const Table& table : tables) names.push_back(table.scenario);
  std::vector<std::size_t> order = telling_order(names, tables, set);
  std::size_t bytes = 0;
  std::size_t kept = 0;
  for (; kept < order.size(); ++kept) {
    bytes += bytes_of(tables[order[kept]]);
    if (bytes > most_bytes) break;
  }
  if (kept == order.size()) return;
  data.thinned.push_back(fmt::format(
      "numbers of {} of {} scenarios; those that failed or broke a limit are shown first, and {} has all",
      order.size() - kept, order.size(), file));
  order.resize(kept);
  std::sort(order.begin(), order.end());
  std::vector<Table> shown;
  shown.reserve(kept);
  for (const std::size_t i : order) shown.push_back(std::move(tables[i]));
  tables = std::move(shown);
}

void shorten_front(Front& front, ReportData& data) {
  constexpr std::size_t kMost = 2000;
  if (front.points.size() <= kMost) return;
  const std::size_t all = front.points.size();
  std::vector<FrontPoint> kept;
  for (std::size_t i = 0; i < all; ++i) {
    // Keeps points evenly over the front, because the points are sorted.
    const bool chosen = i * kMost / all != (i + 1) * kMost / all;
    if (chosen || front.points[i].role != "point") kept.push_back(std::move(front.points[i]));
  }
  data.thinned.push_back(fmt::format("{} of {} points of the trade-off", all - kept.size(), all));
  front.points = std::move(kept);
}

/// Returns, for each evaluation, true if it is shown.
std::vector<bool> best_and_worst(const Evaluations& e) {
  constexpr std::size_t kBuckets = 6000;  // keeps three of each, and start and chosen
  const std::size_t all = e.objective.size();
  std::vector<bool> keep(all, false);
  for (const long i : {e.start, e.chosen}) {
    if (i >= 0) keep[static_cast<std::size_t>(i)] = true;
  }
  for (std::size_t b = 0; b < kBuckets; ++b) {
    std::optional<std::size_t> best[2];  // best infeasible and best feasible one
    std::optional<std::size_t> worst;
    for (std::size_t i = b * all / kBuckets; i < (b + 1) * all / kBuckets; ++i) {
      if (!std::isfinite(e.objective[i])) continue;
      auto& own = best[e.feasible[i] ? 1 : 0];
      if (!own || e.objective[i] < e.objective[*own]) own = i;
      if (!worst || e.objective[i] > e.objective[*worst]) worst = i;
    }
    for (const auto& i : {best[0], best[1], worst}) {
      if (i) keep[*i] = true;
    }
  }
  return keep;
}

ThinnedEvaluations counts_of(const Evaluations& e) {
  constexpr std::size_t kMostPhaseRuns = 500;
  ThinnedEvaluations counts;
  counts.total = e.objective.size();
  for (std::size_t i = 0; i < counts.total; ++i) {
    counts.feasible += e.feasible[i] ? 1 : 0;
    counts.native += !e.native.empty() && e.native[i] ? 1 : 0;
    counts.without_objective += std::isfinite(e.objective[i]) ? 0 : 1;
    std::vector<PhaseRun>& runs = counts.phase_runs;
    if (counts.more_phase_runs) continue;
    if (!runs.empty() && runs.back().phase == e.of[i]) {
      runs.back().to = i;
    } else if (runs.size() < kMostPhaseRuns) {
      runs.push_back({e.of[i], i, i});
    } else {
      counts.more_phase_runs = true;
    }
  }
  return counts;
}

}  // namespace

void shorten(ReportData& data) {
  constexpr std::size_t kMostRows = 1000;
  constexpr std::size_t kMostHistograms = 300;
  constexpr std::size_t kTableBytes = 1'000'000;
  const std::size_t set = data.sets.empty() ? 0 : data.sets.size() - 1;
  shorten_tables(data.tables, data.judged ? kTableBytes / 2 : kTableBytes, set, "errors.csv", data);
  if (data.judged) shorten_tables(data.judged->tables, kTableBytes / 2, set, "robust_errors.csv", data);
  if (data.evaluations) {
    const std::size_t all = data.evaluations->objective.size();
    thin(*data.evaluations);
    const std::size_t left = all - data.evaluations->objective.size();
    if (left > 0)
      data.thinned.push_back(fmt::format("{} of {} evaluations; all are in evaluations.csv", left, all));
  }
  if (data.front) shorten_front(*data.front, data);
  keep_first(data.gains, kMostRows, "gains", data);
  keep_first(data.sensitivity, kMostRows, "rows of sensitivity.csv", data);
  keep_first(data.margins, kMostRows, "rows of margins.csv", data);
  keep_first(data.yardstick, kMostRows, "rows of yardstick.csv", data);
  if (data.robustness)
    keep_first(data.robustness->histograms, kMostHistograms, "histograms; summary.csv has the numbers of all",
               data);
  keep_first(data.verdict.details, kMostHistograms, "lines of this list", data);
  keep_first(data.provenance.entries, kMostRows, "entries of run.json", data);
  for (ReportScenario& scenario : data.scenarios)
    keep_first(scenario.limits, kMostRows, "rows of limits.csv", data);
}

void drop_meshes(std::size_t bytes, ReportData& data) {
  std::size_t size = report_json(data).size();
  for (auto arm = data.arms.rbegin(); arm != data.arms.rend() && size > bytes; ++arm) {
    const std::size_t dropped = draw_without_meshes(*arm);
    if (dropped == 0) continue;
    size -= std::min(size, dropped);
    data.thinned.push_back(
        fmt::format("meshes of {}; links without other shapes are drawn as capsules", arm->name));
  }
}

void thin(Evaluations& e) {
  constexpr std::size_t kMost = 20'000;
  const std::size_t all = e.objective.size();
  if (all <= kMost) return;
  const std::vector<bool> keep = best_and_worst(e);
  Evaluations shown;
  shown.phases = e.phases;
  shown.thinned = counts_of(e);
  for (std::size_t i = 0; i < all; ++i) {
    if (!keep[i]) continue;
    if (static_cast<long>(i) == e.start) shown.start = static_cast<long>(shown.of.size());
    if (static_cast<long>(i) == e.chosen) shown.chosen = static_cast<long>(shown.of.size());
    shown.thinned->number.push_back(i);
    shown.of.push_back(e.of[i]);
    shown.objective.push_back(e.objective[i]);
    shown.feasible.push_back(e.feasible[i]);
    shown.violation.push_back(e.violation[i]);
    if (!e.native.empty()) shown.native.push_back(e.native[i]);
  }
  e = std::move(shown);
}

}  // namespace armtune::internal::report
