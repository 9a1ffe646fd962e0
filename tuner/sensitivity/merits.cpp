#include "tuner/sensitivity/merits.hpp"

#include <algorithm>
#include <cmath>

#include "tuner/evaluation/simulate_points.hpp"

namespace armtune::internal {
namespace {

/// Merits with a smaller relative difference count as equal. Rounding makes engines differ by about 1e-13.
constexpr double kSame = 1e-6;

}  // namespace

std::optional<std::vector<double>> Merits::of(const std::vector<std::vector<double>>& points, Engine engine) {
  all_ += points.size();
  auto evaluations = simulate_points(study_, points, workers_, stop_, {engine, objective_.end_limits()},
                                     [this](std::size_t, const Evaluation&) {
                                       ++done_;
                                       if (progress_) progress_(done_, all_);
                                     });
  if (!evaluations) return std::nullopt;
  std::vector<double> merits;
  merits.reserve(points.size());
  for (Evaluation& e : *evaluations) {
    objective_.judge(e);
    merits.push_back(e.objective + study_.solver.penalty * e.violation);
  }
  return merits;
}

std::optional<std::vector<double>> Merits::confirmed(const std::vector<std::vector<double>>& points,
                                                     std::vector<double> merits, std::size_t most_important) {
  std::vector<std::size_t> again;
  again.reserve(points.size());
  for (std::size_t i = 0; points_of(i).reset < points.size(); ++i) again.push_back(points_of(i).reset);
  std::stable_sort(again.begin(), again.end(),
                   [&](std::size_t a, std::size_t b) { return merits[a] > merits[b]; });
  again.resize(std::min(again.size(), most_important));
  again.push_back(0);  // the best
  std::vector<std::vector<double>> chosen;
  chosen.reserve(again.size());
  for (const std::size_t p : again) chosen.push_back(points[p]);
  const auto judged = of(chosen, Engine::kSimbody);
  if (!judged) return std::nullopt;
  bool same = true;
  for (std::size_t k = 0; k < again.size(); ++k) {
    double& merit = merits[again[k]];
    same = same && std::abs(merit - (*judged)[k]) <= kSame * std::abs((*judged)[k]);
    merit = (*judged)[k];
  }
  return same ? std::optional(std::move(merits)) : of(points, Engine::kSimbody);
}

}  // namespace armtune::internal
