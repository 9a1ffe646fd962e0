#pragma once
// yardstick.csv read back: each event of a rollout beside the best that the arm's limits allow, in words.

#include <optional>
#include <string>
#include <vector>

#include "sim/csv/csv_table.hpp"

namespace armtune::report {

struct YardstickRow {
  std::size_t set = 0;
  std::string scenario;
  std::string event;     ///< switch, return, lap
  double time = 0.0;     ///< when it begins [s]
  double reached = 0.0;  ///< of `unit`; NaN where it was not
  double limit = 0.0;    ///< of `unit`; NaN where none was found
  double ratio = 0.0;    ///< NaN where there is none
  std::string unit;      ///< s, rad
  std::string outcome;
  std::string held_back_by;
  std::string status;
  std::string words;  ///< "reacquired in 1.48 s; the joint limits allow 1.21 s (velocity of elbow_joint)"
};

/// One file per set; none where there is no file. Throws InputError naming file and column.
std::vector<YardstickRow> yardstick_of(const std::vector<std::optional<CsvTable>>& sets);

/// How far a set is from the best, at its worst switch, return and lap, in a sentence; empty without a ratio.
std::string yardstick_sentence(const std::vector<YardstickRow>& rows, std::size_t set);

}  // namespace armtune::report
