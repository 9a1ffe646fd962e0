#pragma once
// Shows which gains matter. Each gain is rated by its effect near the best gains, by its rank correlation
// over all evaluations of the search (the journal), and by its part in the improvement.
//
// The effect is measured on the merit: objective + penalty * violation, with the study's penalty. If the best
// point lies at constraints, the objective alone would call every step across a constraint an improvement.

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
  double best = 0.0;          ///< the gain's value
  /// Largest relative change of the merit for a step of kSensitivityStep of the parameter's range either way.
  double local = 0.0;
  /// Relative change of the merit per relative change of the gain, by central differences (one-sided at a
  /// bound); NaN for a gain of zero.
  double elasticity = 0.0;
  /// Spearman's rank correlation of the parameter with the merit over the journal. NaN with fewer than three
  /// rows or for a parameter that never changed.
  double rank_correlation = 0.0;
  /// Increase of the merit if this gain alone is set back to its start: its part in the improvement.
  double importance = 0.0;
};

inline constexpr double kSensitivityStep = 0.02;

/// Number of the most important gains that a run's summary shows.
inline constexpr std::size_t kMostShown = 8;

/// Number of the most important gains for which Simbody confirms the result of another engine.
inline constexpr std::size_t kConfirmed = 3;

struct Sensitivity {
  double merit = 0.0;                            ///< merit of the best
  std::vector<ParameterSensitivity> parameters;  ///< the most important first
};

/// Simulates 3 points per parameter about `best`, in the engine that the study searches in. If that is not
/// Simbody, Simbody confirms the best and the importance of the kConfirmed most important gains, and its
/// figures replace the others. If it finds another merit, it simulates all points. No value if `stop` became
/// true before the end. objective: of the study. progress(done, all): evaluations; all may still grow.
std::optional<Sensitivity> sensitivity(
    const Study& study, const Objective& objective, const Gains& best,
    const std::vector<EvaluationRow>& journal, CandidateRunner& workers, const std::atomic<bool>& stop,
    const std::function<void(std::size_t done, std::size_t all)>& progress = {});

/// Returns Spearman's rank correlation of two series of one length, ties at their mean rank; NaN if it is not
/// defined.
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

/// Returns the text of sensitivity.csv: one row per parameter, the most important first. Numbers read back to
/// the same bits. A missing figure is an empty cell, and `status` says why it is missing.
std::string sensitivity_csv(const Study& study, const Sensitivity& sensitivity);

/// Returns advice in plain words, one line each: gains that ended at a bound, gains without effect, and what
/// to change.
std::vector<std::string> advice(const Study& study, const Sensitivity& sensitivity);

/// Returns the study with the less important half of its parameters fixed at their start values.
Study without_less_important_half(const Study& study, const Sensitivity& sensitivity);

}  // namespace armtune::internal
