#include "tuner/report/series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace armtune::internal::report {

double Series::at(std::size_t i) const {
  if (steps[i] == kNoValue) return std::numeric_limits<double>::quiet_NaN();
  const double part = static_cast<double>(steps[i]) / kSteps;
  return (1.0 - part) * lo + part * hi;  // exact at both ends, and no overflow of hi - lo
}

Series quantize(std::span<const double> values) {
  Series series;
  bool any = false;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    series.lo = any ? std::min(series.lo, value) : value;
    series.hi = any ? std::max(series.hi, value) : value;
    any = true;
  }
  // Halves are used, so that the width of a column of a diverged run does not overflow.
  const double half_width = 0.5 * series.hi - 0.5 * series.lo;
  series.steps.reserve(values.size());
  for (const double value : values) {
    if (!std::isfinite(value)) {
      series.steps.push_back(Series::kNoValue);
      continue;
    }
    const double part = half_width > 0.0 ? (0.5 * value - 0.5 * series.lo) / half_width : 0.0;
    series.steps.push_back(
        static_cast<std::uint16_t>(std::lround(std::clamp(part, 0.0, 1.0) * Series::kSteps)));
  }
  return series;
}

}  // namespace armtune::internal::report
