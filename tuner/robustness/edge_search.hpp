#pragma once
// Searches for the value of one quantity beyond which a condition fails. Stability margins are found in this
// way, for example the largest extra delay with which a control loop remains stable.

#include <functional>
#include <optional>

namespace armtune::internal {

/// The start, the strides and the end of a search.
struct EdgeSearch {
  double nominal = 1.0;     ///< value for which the condition is known to hold; >= 0
  double first = 0.0;       ///< tried first if nominal is zero
  double stride = 2.0;      ///< factor from one value tried to the next: above 1 upwards, below 1 downwards
  double last = 1e3;        ///< nothing beyond it is tried
  bool whole = false;       ///< whole numbers only, upwards
  double tolerance = 0.02;  ///< relative distance at which two numbers that are not whole are neighbours
};

/// The two neighbouring values between which the condition changes.
struct Edge {
  double holds = 0.0;
  std::optional<double> fails;  ///< none: everything up to EdgeSearch::last holds
};

/// Tries values in growing distance from nominal until `holds(value)` returns false. Then bisects between the
/// last two values, to adjacent whole numbers or to the tolerance. Values beyond this first failure are never
/// tried. Numbers that are not whole are tried with four significant digits, so that the printed value
/// is the one tried. If `first` fails already, the search goes down to a thousandth of it and then returns
/// zero.
Edge find_edge(const EdgeSearch& search, const std::function<bool(double)>& holds);

}  // namespace armtune::internal
