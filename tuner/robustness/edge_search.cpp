#include "tuner/robustness/edge_search.hpp"

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

/// Below this share of EdgeSearch::first a value counts as zero.
constexpr double kZero = 1e-3;

/// Rounds to four significant digits. Powers of ten up to 1e22 are exact, so the result is the double nearest
/// to the decimal number.
double rounded(double value) {
  if (value == 0.0) return 0.0;
  const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
  constexpr int kDigits = 4;
  const int shift = kDigits - 1 - exponent;
  const double scale = std::pow(10.0, std::abs(shift));
  return shift >= 0 ? std::round(value * scale) / scale : std::round(value / scale) * scale;
}

double next(const EdgeSearch& search, double value) {
  double wanted = value == 0.0 ? search.first : value * search.stride;
  wanted = search.whole ? std::max(std::round(wanted), value + 1.0) : rounded(wanted);
  return search.stride > 1.0 ? std::min(wanted, search.last) : std::max(wanted, search.last);
}

bool neighbours(const EdgeSearch& search, double a, double b) {
  if (search.whole) return std::abs(a - b) <= 1.0;
  const double larger = std::max(a, b);
  return larger <= kZero * search.first || std::abs(a - b) <= search.tolerance * larger;
}

double middle(const EdgeSearch& search, double a, double b) {
  if (search.whole) return std::floor(0.5 * (a + b));
  return rounded(std::min(a, b) > 0.0 ? std::sqrt(a * b) : 0.5 * (a + b));
}

}  // namespace

Edge find_edge(const EdgeSearch& search, const std::function<bool(double)>& holds) {
  Edge edge{search.nominal, {}};
  while (!edge.fails) {
    const double value = next(search, edge.holds);
    const bool further = search.stride > 1.0 ? value > edge.holds : value < edge.holds;
    if (!further) return edge;
    if (holds(value)) {
      edge.holds = value;
    } else {
      edge.fails = value;
    }
  }
  while (!neighbours(search, edge.holds, *edge.fails)) {
    const double value = middle(search, edge.holds, *edge.fails);
    if (value == edge.holds || value == *edge.fails) break;  // a tolerance finer than four digits
    if (holds(value)) {
      edge.holds = value;
    } else {
      edge.fails = value;
    }
  }
  return edge;
}

}  // namespace armtune::internal
