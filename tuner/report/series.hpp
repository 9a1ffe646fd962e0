#pragma once
// A column of numbers in compressed form. Each number is rounded to one of 65535 equally spaced values
// between the smallest and the largest number of the column, and takes two bytes. A report page stores its
// plots and replays in this form.

#include <cstdint>
#include <span>
#include <vector>

#include "tuner/report/base64.hpp"

namespace armtune::internal::report {

struct Series {
  static constexpr std::uint16_t kSteps = 65534;    ///< number of steps from lo to hi
  static constexpr std::uint16_t kNoValue = 65535;  ///< code of NaN and of infinite numbers

  double lo = 0.0;                   ///< smallest finite number; 0 if no number is finite
  double hi = 0.0;                   ///< largest finite number; 0 if no number is finite
  std::vector<std::uint16_t> steps;  ///< each number as its distance from lo in steps, or kNoValue

  /// Returns the number at index i, or NaN if its code is kNoValue. The rounding error is at most half a
  /// step, that is, (hi - lo) / 131068. The numbers lo and hi themselves are exact.
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
