#pragma once
// Finds the main facts in a run's tables of metrics: the metrics that differ between the first gain set and
// another one, the limits that are broken, and the joint that comes closest to its velocity limit.

#include <optional>
#include <string>
#include <vector>

#include "tuner/report/report_data.hpp"
#include "tuner/report/study_facts.hpp"

namespace armtune::internal::report {

/// The change of a metric from the first gain set to another one. Only scenarios in which both values are
/// positive count.
struct Change {
  Metric metric = Metric::kPositionMax;
  double ratio = 1.0;  ///< value of the other set divided by that of the first; geometric mean over scenarios
  std::vector<std::string> scenarios;  ///< scenarios that the mean is taken over
  /// Returns the ratio, or its inverse if larger values of the metric are better. A result below 1 is an
  /// improvement.
  double worsening() const;
};

/// Returns the changes from the first gain set to the set with the index `set`, for the metrics of `terms`.
/// The best improvement comes first. A term holds a metric and its scenarios; an empty list means all
/// scenarios. A metric without a scenario in which both values are positive is left out.
std::vector<Change> changes(const std::vector<Table>& tables, const std::vector<StudyTerm>& terms,
                            std::size_t set);

/// The values of a metric in one scenario, for the first gain set and for another one.
struct Step {
  Metric metric = Metric::kPositionMax;
  std::string scenario;
  double before = 0.0;
  double after = 0.0;
};

/// Returns the metric and the scenario in which the metric got worse by the largest ratio, or nothing if none
/// got worse. Pairs of values that are not both positive are ignored.
std::optional<Step> worst_step(const std::vector<Table>& tables, const std::vector<Metric>& metrics,
                               std::size_t set);

/// Returns a clause about the joint with the largest velocity ratio over all scenarios of a set, such as
/// "wrist_1_joint comes closest to its velocity limit, 88 % at 6.01 s in SCENARIO". Above 100 % the joint
/// "breaks its velocity limit". The text is empty if no table has a velocity ratio.
std::string closest_joint(const std::vector<Table>& tables, std::size_t set);

/// Returns one line for each scenario that a set did not complete, with the reason.
std::vector<std::string> failures(const std::vector<Table>& tables, std::size_t set);

/// Returns one line for each limit that a set breaks in a scenario that it completed. If a limit has no
/// value, the first set's value of the metric is the limit.
std::vector<std::string> violations(const std::vector<Table>& tables, const std::vector<StudyLimit>& limits,
                                    std::size_t set);

/// Returns the arm's own limits: on joint velocity, position, effort and acceleration. They hold in addition
/// to the limits of a study.
std::vector<StudyLimit> limits_of_arm();

/// Returns the failures followed by the violations.
std::vector<std::string> wrong_with(const std::vector<Table>& tables, const std::vector<StudyLimit>& limits,
                                    std::size_t set);

/// Returns one line for each limit of the arm that is broken in a scenario. If a limit in `asked` on the same
/// metric is broken there too, the line is left out.
std::vector<std::string> beyond_arm(const std::vector<Table>& tables, const std::vector<StudyLimit>& asked,
                                    std::size_t set);

}  // namespace armtune::internal::report
