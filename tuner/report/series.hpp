#pragma once
// One column of numbers in two bytes each: linear between its smallest and its largest value.

#include <cstdint>
#include <span>
#include <vector>

namespace armtune::report {

struct Series {
  static constexpr std::uint16_t kSteps = 65534;    ///< from lo to hi
  static constexpr std::uint16_t kNoValue = 65535;  ///< NaN or infinite

  double lo = 0.0;  ///< 0 where no number is finite
  double hi = 0.0;
  std::vector<std::uint16_t> steps;

  /// The number at i, half a step (hi - lo) / 131068 off at most, lo and hi exact; NaN where there is none.
  double at(std::size_t i) const;
};

Series quantize(std::span<const double> values);

}  // namespace armtune::report
