#pragma once
// Finds the main facts in a run's tables of metrics: which metrics changed from the first gain set to another
// one, which limits are broken, and which joint comes closest to its limit.

#include <optional>
#include <string>
#include <vector>

#include "tuner/report/report_data.hpp"
#include "tuner/report/study_facts.hpp"

namespace armtune::internal::report {

/// The change of a metric from the first gain set to another one: the geometric mean of the ratios over the
/// scenarios where both values are positive.
struct Change {
  Metric metric = Metric::kPositionMax;
  double ratio = 1.0;
  std::vector<std::string> scenarios;  ///< scenarios that the mean is taken over
  /// Returns the ratio, or its inverse if larger is better. A value below 1 is an improvement.
  double worsening() const;
};

/// Returns the changes of the metrics of `terms` from the first gain set to that with the index `set`, best
/// improvement first. A term holds a metric and its scenarios; no scenarios mean all. A metric that has no
/// scenario with positive values is left out.
std::vector<Change> changes(const std::vector<Table>& tables, const std::vector<StudyTerm>& terms,
                            std::size_t set);

/// The values of a metric in one scenario, for the first gain set and for another one.
struct Step {
  Metric metric = Metric::kPositionMax;
  std::string scenario;
  double before = 0.0;
  double after = 0.0;
};

/// Returns the largest worsening of any of the metrics, by ratio, or nothing if none got worse.
std::optional<Step> worst_step(const std::vector<Table>& tables, const std::vector<Metric>& metrics,
                               std::size_t set);

/// Returns "wrist_1_joint comes closest to its velocity limit, 88 % at 6.01 s in SCENARIO" or, above 100 %,
/// that it breaks the limit, over all scenarios of a set. Empty if no table has such a ratio.
std::string closest_joint(const std::vector<Table>& tables, std::size_t set);

/// Returns one line for each scenario that a set did not complete, with the reason.
std::vector<std::string> failures(const std::vector<Table>& tables, std::size_t set);

/// Returns one line for each limit that a set breaks in a scenario that it completed. For a limit without a
/// value of its own, the first set's value counts.
std::vector<std::string> violations(const std::vector<Table>& tables, const std::vector<StudyLimit>& limits,
                                    std::size_t set);

/// Returns the limits that every arm has, in addition to those of a study.
std::vector<StudyLimit> limits_of_arm();

/// Returns the failures followed by the violations.
std::vector<std::string> wrong_with(const std::vector<Table>& tables, const std::vector<StudyLimit>& limits,
                                    std::size_t set);

/// Returns the limits of the arm that are broken in a scenario, except where a limit in `asked` on the same
/// metric is broken too.
std::vector<std::string> beyond_arm(const std::vector<Table>& tables, const std::vector<StudyLimit>& asked,
                                    std::size_t set);

}  // namespace armtune::internal::report
