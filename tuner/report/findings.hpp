#pragma once
// What the tables of a run show: how figures changed, what is broken, which joint comes closest to its limit.

#include <optional>
#include <string>
#include <vector>

#include "tuner/report/report_data.hpp"
#include "tuner/report/study_facts.hpp"

namespace armtune::internal::report {

/// How a metric of a set compares with the first set's: the geometric mean of the ratios over the scenarios
/// where both are positive.
struct Change {
  Metric metric = Metric::kPositionMax;
  double ratio = 1.0;
  std::vector<std::string> scenarios;  ///< that it is the mean of
  /// The ratio, or its inverse where larger is better; below 1 is better.
  double worsening() const;
};

/// Best improvement first; a metric without such scenarios is left out. terms: which metrics in which
/// scenarios; no scenarios: all.
std::vector<Change> changes(const std::vector<Table>& tables, const std::vector<StudyTerm>& terms,
                            std::size_t set);

/// A metric of one scenario, of the first set and of another.
struct Step {
  Metric metric = Metric::kPositionMax;
  std::string scenario;
  double before = 0.0;
  double after = 0.0;
};

/// Which of the metrics got worse the most, by ratio, and where; nothing if none did.
std::optional<Step> worst_step(const std::vector<Table>& tables, const std::vector<Metric>& metrics,
                               std::size_t set);

/// "wrist_1_joint comes closest to its velocity limit, 88 % at 6.01 s in SCENARIO", over all scenarios of a
/// set; empty where no table has a ratio.
std::string closest_joint(const std::vector<Table>& tables, std::size_t set);

/// One line per scenario that a set did not complete, with the reason.
std::vector<std::string> failures(const std::vector<Table>& tables, std::size_t set);

/// One line per limit that a set breaks in a scenario that completed. Limits without a value of their own are
/// the first set's.
std::vector<std::string> violations(const std::vector<Table>& tables, const std::vector<StudyLimit>& limits,
                                    std::size_t set);

/// What every arm asks for, whether a study does or not.
std::vector<StudyLimit> limits_of_arm();

/// Failures, then violations.
std::vector<std::string> wrong_with(const std::vector<Table>& tables, const std::vector<StudyLimit>& limits,
                                    std::size_t set);

/// Limits of the arm that are broken where no limit of those asked for on the same metric is.
std::vector<std::string> beyond_arm(const std::vector<Table>& tables, const std::vector<StudyLimit>& asked,
                                    std::size_t set);

}  // namespace armtune::internal::report
