#pragma once
// Models the objective and the constraints of a study around one gain set, metric by metric, as a minimax
// problem (minimax_model.hpp). Peaks and derivatives come from the native engine. The values come from the
// evaluation of the gain set in the engine of the search: all rows of a metric are shifted by the difference
// between the two engines.

#include "tuner/derivatives/metric_derivatives.hpp"
#include "tuner/minimax/minimax_model.hpp"
#include "tuner/study/objective.hpp"

namespace armtune::internal {

/// Returns the model at the evaluated gain set. Its variables are the search coordinates. Its terms are those
/// of the objective up to a constant, one for each scenario. Its constraints are those of the study, in
/// order, as relative excess (Evaluation::relative) plus `inside`. A constraint therefore counts as satisfied
/// only if it holds with this reserve. A metric without a value or without derivatives has no rows.
///
/// Random arms: for the worst value over the arms, the samples of all arms are rows of one maximum. Other
/// risk measures are weighted sums over the arms. The weights are those of the evaluated gain set.
///
/// study: has terms, not a user's own objective; e: judged by `objective`; derivatives: at e.x.
MinimaxModel metric_model(const Study& study, const Objective& objective, const Evaluation& e,
                          const MetricDerivatives& derivatives, double inside);

}  // namespace armtune::internal
