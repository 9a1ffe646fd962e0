#pragma once
// A study without files, for derivatives by some of its gains.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "tests/sim/support/law_jobs.hpp"
#include "tuner/derivatives/metric_derivatives.hpp"

namespace armtune::internal::test {

/// A study of some gains of a controller: each from a fifth of its start value to five times this value.
inline Study study_of_gains(std::vector<Scenario> scenarios, const Gains& gains, std::size_t count) {
  Study study;
  study.name = "derivatives";
  study.space.start = gains;
  std::vector<GainEntry> entries;
  for (const GainEntry& entry : gain_entries(gains, joint_names(*scenarios.front().robot))) {
    if (entry.field->search == SearchRange::kFactor && value(gains, entry) > 0.0) entries.push_back(entry);
  }
  count = std::min(count, entries.size());
  for (std::size_t i = 0; i < count; ++i) {
    const GainEntry& entry = entries[i * (entries.size() - 1) / std::max<std::size_t>(1, count - 1)];
    const double v = value(gains, entry);
    study.space.free.push_back({entry, v, 0.2 * v, 5.0 * v, i == 0 ? Scale::kLinear : Scale::kLog});
  }
  study.scenarios = std::move(scenarios);
  return study;
}

/// Every metric in every scenario in which it applies.
inline std::vector<MetricUse> uses_of(const std::vector<Metric>& metrics, std::size_t scenarios) {
  std::vector<MetricUse> uses;
  for (std::size_t s = 0; s < scenarios; ++s) {
    for (const Metric metric : metrics) uses.push_back({metric, s});
  }
  return uses;
}

}  // namespace armtune::internal::test
