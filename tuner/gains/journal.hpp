#pragma once
// evaluations.csv: every finished evaluation, on disk as soon as it is done.

#include <string>

#include "sim/rollout/columns.hpp"
#include "tuner/gains/study.hpp"

namespace armtune {

/// Name, unit and meaning of every column of a study's evaluations.csv.
std::vector<Column> journal_columns(const Study& study);

class Journal {
 public:
  /// Makes the file with its header. Throws InputError if it exists or cannot be made.
  Journal(const std::string& path, const Study& study);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Appends one row and hands it to the disk. seconds: wall time since the run began; in the last column,
  /// the only one that differs between two runs of one study. Throws std::runtime_error if the disk refuses
  /// it.
  void append(const std::string& phase, const Evaluation& e, double seconds);

 private:
  void write(const std::string& text);

  std::string path_;
  const Study& study_;
  int file_ = -1;
  long count_ = 0;
};

}  // namespace armtune
