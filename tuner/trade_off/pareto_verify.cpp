// The front simulated again: what is reported is what anyone gets who runs these gains.

#include <fmt/format.h>

#include <stdexcept>

#include "tuner/trade_off/pareto.hpp"
#include "tuner/workers/simulate_points.hpp"

namespace armtune {

bool verify(const Study& study, const Objective& objective, const ParetoOptions& options,
            ParetoResult& result, Workers& workers, const std::atomic<bool>& stop) {
  std::vector<std::vector<double>> points;
  points.reserve(result.front.size());
  for (const ParetoPoint& point : result.front) points.push_back(point.e.x);
  auto fresh = simulate_points(study, points, workers, stop, {});
  if (!fresh) return false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Evaluation& e = (*fresh)[i];
    objective.judge(e);
    Costs costs;
    for (const Criterion& criterion : options.criteria) costs.push_back(cost(criterion, e, study.scenarios));
    if (costs != result.front[i].costs || !e.feasible) {
      throw std::runtime_error(fmt::format("evaluation {} simulated again gives {} {} instead of {}",
                                           result.front[i].evaluation, options.criteria.front().name(),
                                           costs.front(), result.front[i].costs.front()));
    }
    result.front[i].e = std::move(e);
  }
  return true;
}

}  // namespace armtune
