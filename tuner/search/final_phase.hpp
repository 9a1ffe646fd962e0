#pragma once
// The final phase of a search: it models every metric of the study separately (metric_model.hpp) and improves
// the best gains by sequential quadratic programming (minimax_search.hpp). An iteration needs one rollout set
// (every scenario of the study) for each tuned gain, with this gain perturbed, and one for the gains
// themselves. These are called copies. They run in the native engine. The new gains are then evaluated in the
// engine of the search.
//
// Budget: a copy counts as one evaluation. Journal: only evaluations are recorded. The derivatives depend on
// study and gains alone, to the bit, so a resumed run computes them again and continues with the same points.

#include <functional>
#include <optional>

#include "tuner/derivatives/metric_derivatives.hpp"
#include "tuner/minimax/minimax_search.hpp"
#include "tuner/study/objective.hpp"
#include "tuner/study/warm_start.hpp"

namespace armtune::internal {

/// Reserve with which the final phase keeps constraints, as relative excess. The limits of the best gains are
/// usually active. Without a reserve, half of the points near them would violate them by rounding.
inline constexpr double kInside = 5e-4;

/// The simulations of the final phase. Each function returns nothing (null) to end the phase.
struct FinalPhaseRollouts {
  std::function<std::optional<MetricDerivatives>(const std::vector<double>& x)> differentiate;
  /// Returns the evaluation of x. It must remain valid until the next call.
  std::function<const Evaluation*(const std::vector<double>& x)> evaluate;
};

/// Returns the number of copies of one iteration.
long copies_per_iteration(const Study& study);

/// Returns the number of evaluations, copies included, that are reserved for the final phase. This is the
/// study's final_share of those that are left. If these are too few for one iteration, it is 0, and there is
/// no final phase. It is also 0 if the study has no final phase. left: evaluations that are left to the local
/// searches and the final phase together.
long final_evaluations(const Study& study, long left);

/// Runs the final phase from the evaluation `best`, which completed every scenario. box: bounds of the
/// search.
MinimaxResult run_final_phase(const Study& study, const Objective& objective, const Evaluation& best,
                              const WarmPoint& box, const FinalPhaseRollouts& rollouts);

}  // namespace armtune::internal
