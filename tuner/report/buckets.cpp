#include "tuner/report/buckets.hpp"

#include <cmath>
#include <limits>

namespace armtune::internal::report {

Buckets::Buckets(std::size_t rows, std::size_t most) : rows_(rows), count_(rows <= 2 * most ? 0 : most) {}

std::size_t Buckets::first_row(std::size_t b) const {
  return b * rows_ / count_;
}

std::vector<double> Buckets::times(std::span<const double> time) const {
  if (whole()) return {time.begin(), time.end()};
  std::vector<double> kept;
  kept.reserve(points());
  for (std::size_t b = 0; b < count_; ++b) {
    const std::size_t first = first_row(b);
    kept.push_back(time[first]);
    kept.push_back(time[first + (first_row(b + 1) - first) / 2]);
  }
  return kept;
}

std::vector<double> Buckets::extremes(std::span<const double> column) const {
  if (whole()) return {column.begin(), column.end()};
  std::vector<double> kept;
  kept.reserve(points());
  for (std::size_t b = 0; b < count_; ++b) {
    double earlier = std::numeric_limits<double>::quiet_NaN();  // NaN until a finite value was seen
    double later = earlier;
    bool rising = true;  // true if the smallest came before the largest
    for (std::size_t r = first_row(b); r < first_row(b + 1); ++r) {
      const double value = column[r];
      if (!std::isfinite(value)) continue;
      if (std::isnan(earlier)) {
        earlier = value;
        later = value;
        continue;
      }
      const double smallest = rising ? earlier : later;
      const double largest = rising ? later : earlier;
      if (value < smallest) {
        earlier = largest;
        later = value;
        rising = false;
      } else if (value > largest) {
        earlier = smallest;
        later = value;
        rising = true;
      }
    }
    kept.push_back(earlier);
    kept.push_back(later);
  }
  return kept;
}

}  // namespace armtune::internal::report
