#pragma once
// What sensitivities are made of: the merits (objective + penalty * violation) of points about the best,
// found in one engine and confirmed by Simbody.

#include <atomic>
#include <functional>
#include <optional>
#include <vector>

#include "tuner/study/study.hpp"
#include "tuner/workers/candidate_runner.hpp"

namespace armtune::internal {

/// Where the points of parameter i stand among all, which begin with the best: a step below it, a step above,
/// and back to the start.
struct PointsOf {
  std::size_t below, above, reset;
};
constexpr PointsOf points_of(std::size_t i) {
  return {1 + 3 * i, 2 + 3 * i, 3 + 3 * i};
}

class Merits {
 public:
  using Progress = std::function<void(std::size_t done, std::size_t all)>;

  /// All outlive this. progress: of the evaluations asked for so far; may be empty.
  Merits(const Study& study, const Objective& objective, CandidateRunner& workers,
         const std::atomic<bool>& stop, const Progress& progress)
      : study_(study), objective_(objective), workers_(workers), stop_(stop), progress_(progress) {}

  /// In order. Nothing if `stop` became true before all were done.
  std::optional<std::vector<double>> of(const std::vector<std::vector<double>>& points, Engine engine);

  /// merits: of another engine, of the points about the best. Simbody simulates the best and the ways back of
  /// the `looked_at` most important parameters; these are its own then. Where it comes to another figure, all
  /// of them are.
  std::optional<std::vector<double>> confirmed(const std::vector<std::vector<double>>& points,
                                               std::vector<double> merits, std::size_t looked_at);

 private:
  const Study& study_;
  const Objective& objective_;
  CandidateRunner& workers_;
  const std::atomic<bool>& stop_;
  const Progress& progress_;
  std::size_t done_ = 0;
  std::size_t all_ = 0;
};

}  // namespace armtune::internal
