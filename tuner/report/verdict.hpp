#pragma once
// Writes the verdict at the top of a report page: one sentence, and a few lines of details. Together they
// name the metrics that improved, the joint that comes closest to its velocity limit, and the limits that are
// broken.

#include <optional>

#include "tuner/report/report_data.hpp"
#include "tuner/report/study_facts.hpp"
#include "tuner/run/run_record.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune::internal::report {

/// The data that a verdict needs in addition to the page's data.
struct VerdictFacts {
  std::optional<StudyFacts> study;
  std::optional<RunRecord> record;          ///< contents of run.json; empty if it is missing or unreadable
  bool ended = true;                        ///< true if there is a run.json, which a run writes at its end
  bool resumable = false;                   ///< true if there is a journal
  std::optional<SimulationVerdict> checks;  ///< contents of verdict.yaml; empty if there is no such file

  /// Returns the facts about the run's search, or null if they are unknown.
  const SearchFacts* search() const { return record && record->search ? &*record->search : nullptr; }
  /// Returns the facts about the gains that the run chose, or null if they are unknown.
  const TunedFacts* tuned() const { return record && record->tuned ? &*record->tuned : nullptr; }
};

/// Returns the verdict. data: the page's data, complete except for the verdict.
Verdict verdict_of(const ReportData& data, const VerdictFacts& facts);

}  // namespace armtune::internal::report
