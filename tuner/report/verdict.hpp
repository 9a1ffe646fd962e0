#pragma once
// Writes the verdict at the top of a report page: one sentence, and a few lines of details. They name the
// metrics that improved, the joint that comes closest to its velocity limit, and the limits that are broken.

#include <map>
#include <optional>

#include "tuner/report/report_data.hpp"
#include "tuner/report/study_facts.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune::internal::report {

/// The data that a verdict needs in addition to the page's data.
struct VerdictFacts {
  std::optional<StudyFacts> study;
  std::map<std::string, std::string> run;   ///< entries of run.yaml; a key is a path such as "versions/eigen"
  bool ended = true;                        ///< true if there is a run.yaml, which a run writes at its end
  bool resumable = false;                   ///< true if there is a journal
  std::optional<SimulationVerdict> checks;  ///< contents of verdict.yaml; empty if there is no such file

  /// Returns an entry of run.yaml, or an empty text if there is none.
  std::string entry(const std::string& key) const { return run.contains(key) ? run.at(key) : ""; }
  /// True if the key `interrupted` of run.yaml is true.
  bool interrupted() const { return entry("interrupted") == "true"; }
};

/// Returns the verdict. data: the page's data, complete except for the verdict.
Verdict verdict_of(const ReportData& data, const VerdictFacts& facts);

}  // namespace armtune::internal::report
