#pragma once
// One finished evaluation or sample as a line of the journal.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sim/rollout/rollout.hpp"

namespace armtune::internal {

struct JournalRecord {
  std::uint64_t number = 0;  ///< of the evaluation or sample, from 0
  std::string phase;
  double seconds = 0.0;                ///< wall time of the run when it was finished
  std::vector<double> x;               ///< search coordinates; empty for a sample
  std::vector<RolloutResult> results;  ///< one per scenario
};

/// One line without its end. Numbers read back to the same bits.
std::string to_line(const JournalRecord& record);

/// Throws std::invalid_argument saying what is wrong.
JournalRecord record_from_line(std::string_view line);

/// Any text as one word without tab or line end, and back.
std::string escaped(std::string_view text);
std::string unescaped(std::string_view text);

}  // namespace armtune::internal
