#pragma once
// Writes the verdict of a report page, which is one sentence and a few lines. They tell which metrics
// improved and by how much, which joint comes closest to its velocity limit and when, and which limits are
// violated.

#include <map>
#include <optional>

#include "tuner/report/report_data.hpp"
#include "tuner/report/study_facts.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune::internal::report {

/// The data that a verdict needs in addition to the page's data.
struct VerdictFacts {
  std::optional<StudyFacts> study;
  std::map<std::string, std::string> run;   ///< run.yaml, with keys as paths
  bool ended = true;                        ///< true if there is a run.yaml, the last file of a run
  bool resumable = false;                   ///< true if there is a journal
  std::optional<SimulationVerdict> checks;  ///< verdict.yaml; empty if the run has none

  /// Returns an entry of run.yaml, or an empty text if there is none.
  std::string entry(const std::string& key) const { return run.contains(key) ? run.at(key) : ""; }
  /// True if the key `interrupted` of run.yaml is true. Older runs have the key `ended` instead.
  bool interrupted() const {
    return run.contains("interrupted") ? entry("interrupted") == "true"
                                       : entry("ended").starts_with("interrupted");
  }
};

/// Returns the verdict. data: complete except for its verdict.
Verdict verdict_of(const ReportData& data, const VerdictFacts& facts);

}  // namespace armtune::internal::report
