#pragma once
// Converts records of a run to lines of its journal, and back. A record is one finished piece of the run's
// work: an evaluation of a search, or the rollouts of one random arm of a Monte Carlo analysis (a sample).

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sim/rollout/rollout.hpp"

namespace armtune::internal {

struct JournalRecord {
  std::uint64_t number = 0;  ///< number of the evaluation or sample, from 0
  std::string phase;
  double seconds = 0.0;                ///< wall time of the run when the work was finished [s]
  std::vector<double> x;               ///< search coordinates; empty for a sample
  std::vector<RolloutResult> results;  ///< one per scenario
};

/// Returns the record as one line without a line end. Numbers have all digits that are needed to read back
/// the same value. Only the wall time is rounded, to milliseconds.
std::string to_line(const JournalRecord& record);

/// Reads a record. Throws std::invalid_argument with the reason if the line is not a record.
JournalRecord record_from_line(std::string_view line);

/// Convert any text into one word without tab or line end, and back.
std::string escaped(std::string_view text);
std::string unescaped(std::string_view text);

}  // namespace armtune::internal
