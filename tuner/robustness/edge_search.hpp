#pragma once
// Searches for the value of one quantity beyond which a condition fails. Stability margins are found in this
// way, for example the largest extra delay with which a control loop remains stable.

#include <functional>
#include <optional>

namespace armtune::internal {

/// The start, the steps and the end of a search.
struct EdgeSearch {
  double nominal = 1.0;     ///< value for which the condition is known to hold; >= 0
  double first = 0.0;       ///< value that is tried first if nominal is zero
  double stride = 2.0;      ///< factor between values tried in sequence; above 1: upwards, below 1: downwards
  double last = 1e3;        ///< last value that is tried
  bool whole = false;       ///< true: tries only whole numbers, upwards
  double tolerance = 0.02;  ///< relative distance of the two values of Edge; not used if `whole`
};

/// The result of a search: two values close to each other, between which the condition changes.
struct Edge {
  double holds = 0.0;           ///< last value for which the condition holds
  std::optional<double> fails;  ///< value for which it fails; none: it holds up to EdgeSearch::last
};

/// Tries values at growing distance from `nominal` until `holds(value)` returns false. Then bisects between
/// the last two values, until they are adjacent whole numbers or within the tolerance. Values beyond the
/// first failure are never tried. Numbers that need not be whole are rounded to four significant digits
/// before they are tried, so that the printed value is the value tried. If `nominal` is zero, values below a
/// thousandth of `first` are not tried. If all values down to there fail, Edge::holds is zero.
Edge find_edge(const EdgeSearch& search, const std::function<bool(double)>& holds);

}  // namespace armtune::internal
