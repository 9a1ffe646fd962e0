#pragma once
// One finished piece of a run's work, stored as one line of its journal: an evaluation of a search, or the
// rollouts of one random arm of a Monte Carlo analysis (a sample).

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sim/rollout/rollout.hpp"

namespace armtune::internal {

struct JournalRecord {
  std::uint64_t number = 0;  ///< number of the evaluation or sample, from 0
  std::string phase;
  double seconds = 0.0;                ///< wall time of the run when it was finished [s]
  std::vector<double> x;               ///< search coordinates; empty for a sample
  std::vector<RolloutResult> results;  ///< one per scenario
};

/// Returns the record as one line without its end. Numbers read back bit-identical.
std::string to_line(const JournalRecord& record);

/// Reads a record. Throws std::invalid_argument with the reason.
JournalRecord record_from_line(std::string_view line);

/// Convert any text into one word without tab or line end, and back.
std::string escaped(std::string_view text);
std::string unescaped(std::string_view text);

}  // namespace armtune::internal
