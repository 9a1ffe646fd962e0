// Simulates the front again, to ensure that anyone who simulates these gains gets the reported results.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "armtune/error.hpp"
#include "tuner/evaluation/simulate_points.hpp"
#include "tuner/trade_off/pareto.hpp"

namespace armtune::internal {

namespace {

/// Largest relative difference between the engines. Unless a motion diverges, they agree far better. A larger
/// difference shows that the search simulated another arm.
constexpr double kEngineTolerance = 1e-3;

/// Returns the index of the first criterion whose costs differ by more than the relative tolerance, or the
/// number of criteria if none does.
std::size_t first_difference(const Costs& a, const Costs& b, double tolerance) {
  for (std::size_t c = 0; c < a.size(); ++c) {
    if (!(std::abs(a[c] - b[c]) <= tolerance * std::max(std::abs(a[c]), std::abs(b[c])))) return c;
  }
  return a.size();
}

}  // namespace

bool verify(const Study& study, const Objective& objective, const ParetoOptions& options,
            ParetoResult& result, CandidateRunner& workers, const std::atomic<bool>& stop) {
  std::vector<std::vector<double>> points;
  points.reserve(result.front.size());
  for (const ParetoPoint& point : result.front) points.push_back(point.e.x);
  auto fresh = simulate_points(study, points, workers, stop, {});
  if (!fresh) return false;
  const bool same_engine = study.engine == Engine::kSimbody;
  std::vector<ParetoPoint> verified;
  verified.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ParetoPoint& seen = result.front[i];
    ParetoPoint point = {seen.evaluation, std::move((*fresh)[i]), {}};
    objective.judge(point.e);
    for (const Criterion& criterion : options.criteria) {
      point.costs.push_back(cost(criterion, point.e, study.scenarios));
    }
    const std::size_t other = first_difference(point.costs, seen.costs, same_engine ? 0.0 : kEngineTolerance);
    if (other < point.costs.size()) {
      throw FailedError(fmt::format("simulating evaluation {} again gives {} {} instead of {}",
                                    seen.evaluation, options.criteria[other].name(), point.costs[other],
                                    seen.costs[other]));
    }
    if (same_engine && !point.e.feasible) {
      throw FailedError(
          fmt::format("evaluation {} kept all constraints at first, but breaks one when it is "
                      "simulated again",
                      seen.evaluation));
    }
    if (point.e.feasible) verified.push_back(std::move(point));
  }
  if (same_engine) {
    result.front = std::move(verified);
  } else {
    settle(result, verified);
  }
  return true;
}

}  // namespace armtune::internal
