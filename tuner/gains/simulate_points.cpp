#include "tuner/gains/simulate_points.hpp"

namespace armtune {

std::optional<std::vector<Evaluation>> simulate_points(const Study& study,
                                                       const std::vector<std::vector<double>>& points,
                                                       Workers& workers, const std::atomic<bool>& stop) {
  std::vector<Gains> gains;
  gains.reserve(points.size());
  for (const auto& x : points) gains.push_back(study.space.gains_at(x));
  auto results = workers.run(gains, stop);
  if (!results) return std::nullopt;
  std::vector<Evaluation> evaluations(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    evaluations[i].x = points[i];
    evaluations[i].gains = std::move(gains[i]);
    evaluations[i].results = std::move((*results)[i]);
  }
  return evaluations;
}

}  // namespace armtune
