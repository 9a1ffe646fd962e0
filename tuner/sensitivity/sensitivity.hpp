#pragma once
// Computes which gains matter. Three numbers rate each gain: the effect of a small step from the best gains,
// the rank correlation between gain and merit over all evaluations of the search, and the gain's part in the
// improvement.
//
// All three use the merit, that is, objective + penalty * violation with the penalty of the study. The best
// gains often lie at the edge of a constraint. There the objective alone would often become better by a step
// that violates the constraint.

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tuner/evaluation/evaluations_reader.hpp"
#include "tuner/study/study.hpp"
#include "tuner/workers/candidate_runner.hpp"

namespace armtune::internal {

struct ParameterSensitivity {
  std::size_t parameter = 0;  ///< index into ParameterSpace::free
  double best = 0.0;          ///< value of the gain in the best gains
  /// Relative change of the merit for a step kSensitivityStep of the parameter; the larger of the changes for
  /// a step up and a step down.
  double local = 0.0;
  /// Relative change of the merit divided by the relative change of the gain. It is computed by central
  /// differences, or by one-sided ones at a bound. NaN if the gain is zero.
  double elasticity = 0.0;
  /// Spearman's rank correlation between the parameter and the merit over the evaluations in the journal. NaN
  /// if there are fewer than three evaluations, or if the parameter never changed.
  double rank_correlation = 0.0;
  /// Increase of the merit if this gain alone is set back to its start value. This is the gain's part in the
  /// improvement, because a higher merit is worse.
  double importance = 0.0;
};

/// Length of a step in search coordinates, in which the range of each parameter is [0, 1].
inline constexpr double kSensitivityStep = 0.02;

/// A run's summary shows this number of the most important gains.
inline constexpr std::size_t kMostShown = 8;

/// If another engine computes the sensitivities, Simbody checks this number of the most important gains. One
/// is enough to notice that the engines differ, and each takes as long as tens of native evaluations.
inline constexpr std::size_t kConfirmed = 1;

struct Sensitivity {
  double merit = 0.0;                            ///< merit of the best gains
  std::vector<ParameterSensitivity> parameters;  ///< the most important first
};

/// Computes the sensitivities from simulations of `best` and of three points per parameter (merits.hpp). They
/// are simulated in the engine in which the study searches. If this engine is not Simbody, Simbody checks the
/// merit of `best` and the importance of the kConfirmed most important gains (Merits::confirmed). Returns
/// nothing if `stop` became true before the end. objective: the objective of the study. progress: receives
/// the number of finished evaluations and the number requested so far, which may still increase.
std::optional<Sensitivity> sensitivity(
    const Study& study, const Objective& objective, const Gains& best,
    const std::vector<EvaluationRow>& journal, CandidateRunner& workers, const std::atomic<bool>& stop,
    const std::function<void(std::size_t done, std::size_t all)>& progress = {});

/// Returns Spearman's rank correlation of two series of equal length. Equal values get the mean of their
/// ranks. The result is NaN if there are fewer than three values, or if all values of a series are equal.
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

/// Returns the text of sensitivity.csv: one row per parameter, the most important first. Numbers have all
/// digits that are needed to read back the same value. If a number is missing, its cell is empty, and the
/// column `status` gives the reason.
std::string sensitivity_csv(const Study& study, const Sensitivity& sensitivity);

/// Returns lines of advice. A line names a gain that ended at a bound or has no effect, and says how to
/// change the study.
std::vector<std::string> advice(const Study& study, const Sensitivity& sensitivity);

/// Returns the study with the less important half of its parameters fixed at their start values.
Study without_less_important_half(const Study& study, const Sensitivity& sensitivity);

}  // namespace armtune::internal
