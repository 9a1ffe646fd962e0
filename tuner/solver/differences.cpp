#include "tuner/solver/differences.hpp"

#include <algorithm>

namespace armtune::internal {
namespace {

/// Returns the one or two values of coordinate i for its difference; none if its bounds are equal.
std::vector<double> stencil(const SolverProblem& problem, const SolverOptions& options, std::size_t i,
                            double xi) {
  const double below = xi - problem.lower_bound(i);
  const double above = problem.upper_bound(i) - xi;
  const double h = options.difference_step;
  if (options.differences == Differences::kCentral && below >= h && above >= h) return {xi + h, xi - h};
  if (above >= h) return {xi + h};
  if (below >= h) return {xi - h};
  if (std::max(above, below) <= 0.0) return {};
  return {above >= below ? problem.upper_bound(i) : problem.lower_bound(i)};
}

}  // namespace

std::vector<std::vector<double>> difference_points(const SolverProblem& problem, const SolverOptions& options,
                                                   const std::vector<double>& x) {
  std::vector<std::vector<double>> points;
  points.reserve(2 * x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (const double xi : stencil(problem, options, i, x[i])) {
      points.push_back(x);
      points.back()[i] = xi;
    }
  }
  return points;
}

void set_gradients(const SolverProblem& problem, const SolverOptions& options, const std::vector<double>& x,
                   const std::vector<SolverValue>& values, SolverAnswer& answer) {
  const std::size_t n = x.size();
  const std::size_t m = problem.constraint_count;
  answer.gradient.assign(n, 0.0);
  answer.constraint_gradients.assign(m * n, 0.0);
  std::size_t next = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::vector<double> places = stencil(problem, options, i, x[i]);
    if (places.empty()) continue;
    const SolverValue& there = values[next++];
    const bool central = places.size() == 2;
    const SolverValue& here = central ? values[next++] : answer.value;
    const double step = places[0] - (central ? places[1] : x[i]);
    answer.gradient[i] = (there.objective - here.objective) / step;
    for (std::size_t c = 0; c < m; ++c) {
      answer.constraint_gradients[c * n + i] = (there.constraints[c] - here.constraints[c]) / step;
    }
  }
}

}  // namespace armtune::internal
