#pragma once
// What a run has shown, in one sentence and a few lines: what got better by how much, which joint comes
// closest to its velocity limit and when, what is violated.

#include <map>
#include <optional>

#include "tuner/report/report_data.hpp"
#include "tuner/report/study_facts.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune::internal::report {

/// What a verdict needs beside the page's data.
struct VerdictFacts {
  std::optional<StudyFacts> study;
  std::map<std::string, std::string> run;   ///< run.yaml, keys as paths
  bool ended = true;                        ///< whether there is a run.yaml, the last file of a run
  bool resumable = false;                   ///< whether there is a journal
  std::optional<SimulationVerdict> checks;  ///< verdict.yaml, of the runs that have one

  /// Of run.yaml; empty where it is not there.
  std::string entry(const std::string& key) const { return run.contains(key) ? run.at(key) : ""; }
  /// By run.yaml's `interrupted`; runs of older versions say it in their `ended` alone.
  bool interrupted() const {
    return run.contains("interrupted") ? entry("interrupted") == "true"
                                       : entry("ended").starts_with("interrupted");
  }
};

/// data: everything but its verdict.
Verdict verdict_of(const ReportData& data, const VerdictFacts& facts);

}  // namespace armtune::internal::report
