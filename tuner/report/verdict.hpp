#pragma once
// What a run has shown, in one sentence and a few lines: what got better by how much, which joint comes
// closest to its velocity limit and when, what is violated.

#include <map>

#include "tuner/report/report_data.hpp"
#include "tuner/report/study_facts.hpp"

namespace armtune::report {

/// What a verdict needs beside the page's data.
struct VerdictFacts {
  std::optional<StudyFacts> study;
  std::map<std::string, std::string> run;  ///< run.yaml, keys as paths
  std::vector<Table>
      judged;  ///< what the study's limits hold for, where that is not the tables: many arms' worst
};

/// data: everything but its verdict.
Verdict verdict_of(const ReportData& data, const VerdictFacts& facts);

/// "wrist_1_joint comes closest to its velocity limit, 88 % at 6.01 s in SCENARIO", over all scenarios of a
/// set; empty where no table has a ratio.
std::string closest_joint(const std::vector<Table>& tables, std::size_t set);

/// One line per limit that a set breaks in a scenario, or that has no value because a scenario did not
/// complete. Limits without a value of their own are the first set's.
std::vector<std::string> violations(const std::vector<Table>& tables, const std::vector<StudyLimit>& limits,
                                    std::size_t set);

/// How a metric of a set compares with the first set's: the geometric mean of the ratios over scenarios where
/// both are positive; a metric for which there are none is left out.
struct Change {
  Metric metric = Metric::kPositionMax;
  double ratio = 1.0;
  /// By how much it got better: the ratio, or its inverse where larger is better; below 1 is better.
  double worsening() const;
};

/// Best improvement first. terms: which metrics in which scenarios; no scenarios: all.
std::vector<Change> changes(const std::vector<Table>& tables, const std::vector<StudyTerm>& terms,
                            std::size_t set);

}  // namespace armtune::report
