#include "tuner/derivatives/peak_rows.hpp"

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

struct WindowPeak {
  std::size_t period = 0;
  std::size_t channel = 0;
  double height = NAN;  ///< value, with the sign for which more is more extreme
  bool local = false;   ///< not below its neighbours
};

/// Returns the most extreme sample of each window of a channel. Windows without a value have a height of NaN.
std::vector<WindowPeak> window_peaks(const MetricSeries& series, std::size_t channel, double sign,
                                     std::size_t window) {
  std::vector<WindowPeak> peaks;
  for (std::size_t k = 0; k < series.periods(); ++k) {
    if (k % window == 0) peaks.push_back({k, channel, NAN, false});
    const double height = sign * series.at(k, channel);
    if (!(height <= peaks.back().height) && !std::isnan(height)) {
      peaks.back().period = k;
      peaks.back().height = height;
    }
  }
  for (std::size_t w = 0; w < peaks.size(); ++w) {
    const bool below_last = w > 0 && peaks[w].height < peaks[w - 1].height;
    const bool below_next = w + 1 < peaks.size() && peaks[w].height < peaks[w + 1].height;
    peaks[w].local = !below_last && !below_next;
  }
  return peaks;
}

}  // namespace

std::vector<SampleRow> peak_rows(const RolloutSeries& rollout, const MetricSeries& series, SeriesKind kind,
                                 const DerivativeOptions& options) {
  const double sign = kind == SeriesKind::kSmallest ? -1.0 : 1.0;
  const auto window = static_cast<std::size_t>(std::max(1L, std::lround(options.spacing / rollout.period)));
  double highest = -INFINITY;
  double lowest = INFINITY;
  for (const double value : series.values) {
    if (std::isnan(value)) continue;
    highest = std::max(highest, sign * value);
    lowest = std::min(lowest, sign * value);
  }
  const double least = highest - options.band * (highest - lowest);
  std::vector<WindowPeak> chosen;
  for (std::size_t c = 0; c < series.channels; ++c) {
    for (const WindowPeak& peak : window_peaks(series, c, sign, window)) {
      if (peak.height >= least) chosen.push_back(peak);
    }
  }
  std::stable_sort(chosen.begin(), chosen.end(), [](const WindowPeak& a, const WindowPeak& b) {
    return a.local != b.local ? a.local : a.height > b.height;
  });
  chosen.resize(std::min(chosen.size(), options.most_rows));
  std::stable_sort(chosen.begin(), chosen.end(),
                   [](const WindowPeak& a, const WindowPeak& b) { return a.height > b.height; });
  std::vector<SampleRow> rows;
  for (const WindowPeak& peak : chosen) {
    SampleRow& row = rows.emplace_back();
    row.period = peak.period;
    row.channel = static_cast<int>(peak.channel);
    row.time = rollout.time(peak.period);
    row.value = series.at(peak.period, peak.channel);
  }
  return rows;
}

}  // namespace armtune::internal
