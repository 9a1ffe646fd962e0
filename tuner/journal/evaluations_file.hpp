#pragma once
// evaluations.csv: every finished evaluation, on disk as soon as it is done.

#include <functional>
#include <string>
#include <vector>

#include "sim/rollout/columns.hpp"
#include "tuner/run/append_file.hpp"
#include "tuner/study/study.hpp"

namespace armtune {

/// A value beside the study's own.
struct ExtraColumn {
  Column column;
  std::function<double(const Evaluation&)> value;
};

/// Name, unit and meaning of every column of a study's evaluations.csv.
std::vector<Column> evaluation_columns(const Study& study, const std::vector<ExtraColumn>& extra = {});

class EvaluationsFile {
 public:
  /// Makes the file with its header. Throws InputError if it exists or cannot be made.
  EvaluationsFile(const std::string& path, const Study& study, std::vector<ExtraColumn> extra = {});

  /// Appends one row and hands it to the disk. seconds: wall time since the run began; in the last column,
  /// the only one that differs between two runs of one study. Throws std::runtime_error if the disk refuses
  /// it.
  void append(const std::string& phase, const Evaluation& e, double seconds);

 private:
  AppendFile file_;
  const Study& study_;
  std::vector<ExtraColumn> extra_;
  long count_ = 0;
};

}  // namespace armtune
