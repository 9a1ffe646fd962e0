#pragma once
// Reads the numbers and time stamps in the cells of a text log.

#include <cstdint>
#include <optional>
#include <string_view>

namespace armtune::internal {

/// Returns the number in a cell. An empty cell, an infinite number, and each of the words nan, null, none,
/// n/a, na and - in upper or lower case count as NaN. true and false are 1 and 0. Returns nothing for other
/// text. decimal_comma: a comma is the decimal point.
std::optional<double> read_log_number(std::string_view cell, bool decimal_comma = false);

/// A time stamp in two parts, so that Unix time stamps keep their digits: 19 digits do not fit into a double.
struct Stamp {
  std::int64_t whole = 0;
  double fraction = 0.0;  ///< above -1 and below 1
};

/// Returns the stamp in a cell: a finite number of size below 4e18, or a date and time such as
/// "2024-05-01T12:00:00.25Z", which becomes seconds since 1970 (UTC). Returns nothing for other text.
std::optional<Stamp> read_stamp(std::string_view cell, bool decimal_comma = false);

/// True if the cell is a date and time.
bool is_date(std::string_view cell);

/// Returns a - b, in the unit of both.
inline double operator-(const Stamp& a, const Stamp& b) {
  return static_cast<double>(a.whole - b.whole) + (a.fraction - b.fraction);
}

}  // namespace armtune::internal
