#pragma once
// Computes the merit (objective + penalty * violation) of the best gains and of gains near them. The
// sensitivities of the gains follow from these merits. If another simulation engine than Simbody computes the
// merits, Simbody checks the most important ones.

#include <atomic>
#include <functional>
#include <optional>
#include <vector>

#include "tuner/study/study.hpp"
#include "tuner/workers/candidate_runner.hpp"

namespace armtune::internal {

/// The indices of three points in a list of points. Point 0 of the list is the best point. The three points
/// differ from it in one parameter only: it is a step lower, a step higher, or at its start value.
struct PointsOf {
  std::size_t below, above, reset;
};
constexpr PointsOf points_of(std::size_t i) {
  return {1 + 3 * i, 2 + 3 * i, 3 + 3 * i};
}

class Merits {
 public:
  using Progress = std::function<void(std::size_t done, std::size_t all)>;

  /// All arguments must outlive this object. progress: receives the number of finished evaluations and the
  /// number requested so far; may be empty.
  Merits(const Study& study, const Objective& objective, CandidateRunner& workers,
         const std::atomic<bool>& stop, const Progress& progress)
      : study_(study), objective_(objective), workers_(workers), stop_(stop), progress_(progress) {}

  /// Returns the merits of the points, in order, or nothing if `stop` became true before all were done.
  std::optional<std::vector<double>> of(const std::vector<std::vector<double>>& points, Engine engine);

  /// Checks `merits`, which another engine computed for `points`, and returns the checked merits. Simbody
  /// simulates the best point again. For each of the first `most_important` parameters by importance it also
  /// simulates the point with that parameter at its start value. The merits from Simbody replace the given
  /// ones. If one of them differs by more than rounding, Simbody simulates all points again. Returns nothing
  /// if `stop` became true before all were done.
  std::optional<std::vector<double>> confirmed(const std::vector<std::vector<double>>& points,
                                               std::vector<double> merits, std::size_t most_important);

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
