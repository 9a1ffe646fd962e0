#include "tuner/derivatives/settling.hpp"

#include <cmath>

namespace armtune::internal {
namespace {

bool is_settling_event(const RolloutSeries& rollout, const MetricSeries& series, std::size_t k) {
  if (std::isnan(series.at(k))) return false;
  if (series.metric == Metric::kGoalSettlingTime) return k == 0 || std::isnan(series.at(k - 1));
  return k > 0 && ((rollout.modes[k] ^ rollout.modes[k - 1]) & kModeTarget) != 0;
}

}  // namespace

Settling settling_after(const RolloutSeries& rollout, const MetricSeries& series, std::size_t event) {
  Settling found{event, event, 0.0};
  std::size_t last = event;  // the last period with a value
  std::size_t k = event;
  for (; k < series.periods() && (k == event || !is_settling_event(rollout, series, k)); ++k) {
    const double now = series.at(k);
    if (std::isnan(now)) continue;
    const double before = series.at(last);
    if (k > event && before >= 0.0 && now < 0.0) {
      found.period = k;
      found.time = rollout.period * (static_cast<double>(last - event) +
                                     static_cast<double>(k - last) * before / (before - now));
    }
    last = k;
  }
  if (series.at(last) >= 0.0) {
    found.period = k;
    found.time = rollout.period * static_cast<double>(k - event);
  }
  return found;
}

std::optional<Settling> longest_settling(const RolloutSeries& rollout, const MetricSeries& series) {
  std::optional<Settling> longest;
  for (std::size_t k = 0; k < series.periods(); ++k) {
    if (!is_settling_event(rollout, series, k)) continue;
    const Settling found = settling_after(rollout, series, k);
    if (!longest || found.time > longest->time) longest = found;
  }
  return longest;
}

}  // namespace armtune::internal
