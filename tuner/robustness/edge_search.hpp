#pragma once
// The edge between what holds and what does not, along one number.

#include <functional>
#include <optional>

namespace armtune::internal {

/// Where a search begins, how it strides and when it ends.
struct EdgeSearch {
  double nominal = 1.0;     ///< known to hold; >= 0
  double first = 0.0;       ///< tried first where nominal is zero
  double stride = 2.0;      ///< factor from one value tried to the next: above 1 upwards, below 1 downwards
  double last = 1e3;        ///< nothing beyond it is tried
  bool whole = false;       ///< whole numbers only, upwards
  double tolerance = 0.02;  ///< relative distance at which two numbers that are not whole are neighbours
};

/// Neighbours on either side of the edge.
struct Edge {
  double holds = 0.0;
  std::optional<double> fails;  ///< none: everything up to EdgeSearch::last holds
};

/// Strides away from nominal until `holds(value)` says no, then bisects between the last two values: to
/// adjacent whole numbers, or to the tolerance. What lies beyond the first failure that the strides meet is
/// never seen. Numbers that are not whole are tried with four significant digits: what is printed is what was
/// tried. Where already `first` fails, the search goes down to a thousandth of it and then gives zero.
Edge find_edge(const EdgeSearch& search, const std::function<bool(double)>& holds);

}  // namespace armtune::internal
