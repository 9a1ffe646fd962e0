// The section with the results of a gain set on many arms, from samples.csv.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "armtune/error.hpp"
#include "core/common/input_place.hpp"
#include "tuner/report/sections.hpp"
#include "tuner/report/tables.hpp"
#include "tuner/rollouts/comparison.hpp"
#include "tuner/samples/statistics.hpp"

namespace armtune::internal::report {
namespace {

constexpr std::size_t kMostBins = 40;
constexpr std::size_t kMostWorst = 20;

/// Counts the values in bins of equal width from the smallest to the largest value. The number of bins is
/// about the square root of the number of values, and at most kMostBins.
void fill(const std::vector<double>& values, Histogram& histogram) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double begin = *low;
  const double width = *high - *low;
  const auto root = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(values.size()))));
  const std::size_t bins = width > 0.0 && std::isfinite(width) ? std::min(kMostBins, root) : 1;
  histogram.counts.assign(bins, 0);
  for (std::size_t b = 0; b <= bins; ++b) {
    histogram.edges.push_back(b == bins ? *high
                                        : begin + width * static_cast<double>(b) / static_cast<double>(bins));
  }
  for (const double value : values) {
    const double part = bins > 1 ? (value - begin) / width * static_cast<double>(bins) : 0.0;
    ++histogram.counts[std::min(static_cast<std::size_t>(part), bins - 1)];
  }
}

/// The name of a scenario, and the indices of its rows.
using ScenarioRows = std::pair<std::string, std::vector<std::size_t>>;

/// Returns the rows of each scenario, in the order in which the scenarios first appear.
std::vector<ScenarioRows> rows_by_scenario(const CsvTable& samples) {
  const std::size_t scenario = samples.column("scenario");
  std::vector<ScenarioRows> all;
  std::map<std::string, std::size_t> places;
  for (std::size_t r = 0; r < samples.rows(); ++r) {
    const std::string name = samples.text(r, scenario);
    const auto [place, is_new] = places.emplace(name, all.size());
    if (is_new) all.emplace_back(name, std::vector<std::size_t>());
    all[place->second].second.push_back(r);
  }
  return all;
}

/// Adds a histogram for each scenario and headline metric that any completed sample has.
void add_histograms(const CsvTable& samples, const std::vector<MetricLimit>& limits,
                    const std::vector<Table>& tables, Robustness& robustness) {
  const std::size_t status = samples.column("status");
  for (const auto& [scenario, rows] : rows_by_scenario(samples)) {
    for (const Metric metric : headline_metrics()) {
      const auto column = samples.find(name(metric));
      if (!column) continue;
      std::vector<double> values;
      std::size_t failed = 0;
      for (const std::size_t r : rows) {
        if (samples.text(r, status) != "completed") {
          ++failed;
          continue;
        }
        const double value = samples.number(r, *column);
        if (std::isfinite(value)) values.push_back(value);
      }
      if (values.empty()) continue;
      Histogram histogram;
      histogram.metric = metric;
      histogram.scenario = scenario;
      histogram.failed = failed;
      for (const MetricLimit& limit : limits) {
        if (limit.metric == metric) histogram.limit = limit.value;
      }
      for (const Table& table : tables) {
        const double nominal = value_of(table, metric, 0);
        if (table.scenario == scenario && !std::isnan(nominal)) histogram.nominal = nominal;
      }
      fill(values, histogram);
      robustness.histograms.push_back(std::move(histogram));
    }
  }
}

/// Returns the number of a sample. Throws InputError if the cell contains no such number.
long sample_in(const CsvTable& samples, std::size_t row, std::size_t column) {
  constexpr double kMost = 1e15;
  const double number = samples.number(row, column);
  if (!(number >= 0.0 && number <= kMost)) {
    throw InputError(at_line(samples.name(), row + 2, samples.header()[column]),
                     fmt::format("'{}' is not a sample number", samples.text(row, column)));
  }
  return static_cast<long>(number);
}

}  // namespace

Robustness robustness_of(const CsvTable& samples, const std::vector<MetricLimit>& limits,
                         const std::vector<Table>& tables) {
  const std::size_t number = samples.column("sample");
  const std::size_t scenario = samples.column("scenario");
  const std::size_t broken = samples.column("broken_limit");
  const std::size_t ratio = samples.column(name(Metric::kJointVelocityMaxRatio));
  const std::size_t joint = samples.column("joint_velocity/max_ratio_joint");
  Robustness found;
  std::map<std::string, bool> keeps;  // by sample
  std::map<std::string, std::size_t> broken_by;
  std::vector<std::pair<double, WorstSample>> worst;
  for (std::size_t r = 0; r < samples.rows(); ++r) {
    const std::string name = samples.text(r, scenario);
    const std::string what = samples.text(r, broken);
    bool& kept = keeps.try_emplace(samples.text(r, number), true).first->second;
    kept = kept && what.empty();
    if (what.empty()) continue;
    ++broken_by[fmt::format("{} in {}", what, name)];
    const double value = samples.number(r, ratio);
    worst.emplace_back(value, WorstSample{sample_in(samples, r, number),
                                          fmt::format("{}: {}; {} at {:.0f} % of its velocity limit", name,
                                                      what, samples.text(r, joint), 100.0 * value)});
  }
  found.samples = keeps.size();
  found.kept = static_cast<std::size_t>(
      std::count_if(keeps.begin(), keeps.end(), [](const auto& sample) { return sample.second; }));
  if (found.samples > 0) found.interval = wilson_interval(found.kept, found.samples);
  found.broken.assign(broken_by.begin(), broken_by.end());
  std::stable_sort(found.broken.begin(), found.broken.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  // A ratio that is NaN belongs to a rollout without a result, which is the worst case.
  const auto rank = [](double value) { return std::isnan(value) ? INFINITY : value; };
  std::stable_sort(worst.begin(), worst.end(),
                   [rank](const auto& a, const auto& b) { return rank(a.first) > rank(b.first); });
  for (std::size_t i = 0; i < worst.size() && i < kMostWorst; ++i) found.worst.push_back(worst[i].second);
  add_histograms(samples, limits, tables, found);
  return found;
}

}  // namespace armtune::internal::report
