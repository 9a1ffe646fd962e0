#pragma once
// A column of numbers, quantised to two bytes each between its smallest and its largest value. A report page
// stores its plots and replays in this form to save space.

#include <cstdint>
#include <span>
#include <vector>

#include "tuner/report/base64.hpp"

namespace armtune::internal::report {

struct Series {
  static constexpr std::uint16_t kSteps = 65534;    ///< from lo to hi
  static constexpr std::uint16_t kNoValue = 65535;  ///< code for NaN or infinite

  double lo = 0.0;  ///< 0 if no number is finite
  double hi = 0.0;
  std::vector<std::uint16_t> steps;

  /// Returns the number at i, or NaN if it is missing. Its error is at most half a step, (hi - lo) / 131068;
  /// lo and hi are exact.
  double at(std::size_t i) const;

  static void declare(auto& f, auto& series) {
    f.type("Series", "One column, thinned and quantised; lo = hi for a constant.");
    f("lo", series.lo)("hi", series.hi);
    f("u16", base64_u16(series.steps),
      "Base64 of little-endian uint16: 0 to 65534 linear from lo to hi, 65535 where the value is not finite.");
  }
};

Series quantize(std::span<const double> values);

}  // namespace armtune::internal::report
