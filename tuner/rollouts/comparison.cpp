#include "tuner/rollouts/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/csv/cell.hpp"

namespace armtune::internal {
namespace {

std::string number(double value) {
  return std::isnan(value) ? "-" : fmt::format("{:.4g}", value);
}

/// Returns value / reference. Returns NaN unless the reference is finite and above zero and the value is not
/// negative, because other ratios have no meaning.
double ratio(double value, double reference) {
  return std::isfinite(reference) && reference > 0.0 && value >= 0.0 ? value / reference : NAN;
}

}  // namespace

const std::vector<Metric>& headline_metrics() {
  static const std::vector<Metric> metrics = {
      Metric::kJointErrorRms,        Metric::kJointErrorMax,
      Metric::kToolErrorMax,         Metric::kGoalSettlingTime,
      Metric::kGoalOvershoot,        Metric::kPositionMax,
      Metric::kOrientationMax,       Metric::kLinearVelocityRms,
      Metric::kAngularVelocityRms,   Metric::kGazeRms,
      Metric::kGazeTimeOutside,      Metric::kReacquisitionTime,
      Metric::kResponseRiseTime,     Metric::kResponseOvershoot,
      Metric::kResponseSettlingTime, Metric::kResponseSteadyStateError,
      Metric::kResponseBandwidth,    Metric::kJointVelocityMaxRatio,
      Metric::kJointEffortMaxRatio,  Metric::kJointPositionMinMargin,
      Metric::kObstacleMinClearance, Metric::kClearanceSelf,
      Metric::kClearanceCell,        Metric::kClearanceFloor,
      Metric::kEffortRateRms};
  return metrics;
}

std::string comparison_table(const std::vector<ComparedSet>& sets, const std::vector<Metric>& metrics) {
  std::size_t width = 10;
  for (const ComparedSet& set : sets) width = std::max(width, set.name.size());
  std::string text;
  for (std::size_t s = 0; s < sets.front().results.size(); ++s) {
    text += fmt::format("{:<34}", sets.front().results[s].scenario);
    for (std::size_t i = 0; i < sets.size(); ++i) {
      text += fmt::format("  {:>{}}", sets[i].name, width);
      if (i > 0) text += fmt::format("  {:>6}", "ratio");
    }
    text += '\n';
    for (const Metric m : metrics) {
      const double reference = sets.front().results[s].result.metrics[m];
      const bool empty = std::all_of(sets.begin(), sets.end(), [&](const ComparedSet& set) {
        return std::isnan(set.results[s].result.metrics[m]);
      });
      if (empty) continue;
      text += fmt::format("  {:<32}", fmt::format("{} [{}]", field(m).name, field(m).unit));
      for (std::size_t i = 0; i < sets.size(); ++i) {
        const double value = sets[i].results[s].result.metrics[m];
        text += fmt::format("  {:>{}}", number(value), width);
        if (i > 0) {
          const double r = ratio(value, reference);
          text += fmt::format("  {:>6}", std::isnan(r) ? "-" : fmt::format("{:.3f}", r));
        }
      }
      text += '\n';
    }
    for (const ComparedSet& set : sets) {
      const RolloutResult& result = set.results[s].result;
      if (result.status != RolloutStatus::kCompleted)
        text += fmt::format("  {}: {}\n", set.name, result.reason);
    }
    text += '\n';
  }
  return text;
}

std::string comparison_csv(const std::vector<ComparedSet>& sets) {
  std::string text = "scenario,metric,unit";
  for (const ComparedSet& set : sets) text += "," + cell(set.name);
  for (std::size_t i = 1; i < sets.size(); ++i) text += "," + cell(sets[i].name + "/ratio");
  text += '\n';
  for (std::size_t s = 0; s < sets.front().results.size(); ++s) {
    for (std::size_t m = 0; m < kMetricCount; ++m) {
      const MetricField& f = metric_fields()[m];
      text += fmt::format("{},{},{}", cell(sets.front().results[s].scenario), f.name, f.unit);
      const double reference = sets.front().results[s].result.metrics.value[m];
      for (const ComparedSet& set : sets) text += "," + cell(set.results[s].result.metrics.value[m]);
      for (std::size_t i = 1; i < sets.size(); ++i) {
        text += "," + cell(ratio(sets[i].results[s].result.metrics.value[m], reference));
      }
      text += '\n';
    }
  }
  return text;
}

}  // namespace armtune::internal
