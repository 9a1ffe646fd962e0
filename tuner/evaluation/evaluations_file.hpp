#pragma once
// evaluations.csv: every finished evaluation, on disk as soon as it is done.

#include <functional>
#include <string>
#include <vector>

#include "sim/rollout/columns.hpp"
#include "tuner/run/append_file.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {

/// A value beside the study's own.
struct ExtraColumn {
  Column column;
  std::function<double(const Evaluation&)> value;
};

/// Name, unit and meaning of every column of a study's evaluations.csv.
std::vector<Column> evaluation_columns(const Study& study, const std::vector<ExtraColumn>& extra = {});

class EvaluationsFile {
 public:
  /// Makes the file with its header. Throws InputError if it cannot be made, or exists and is not to be
  /// replaced.
  EvaluationsFile(const std::string& path, const Study& study, std::vector<ExtraColumn> extra = {},
                  AppendFile::Open open = AppendFile::Open::kNew);

  /// Appends one row and hands it to the system. Numbers read back to the same bits, but the wall time in
  /// milliseconds; what there is not is an empty cell. The wall time stands in the last column, the only one
  /// that differs between two runs of one study. A file that replaces an older one does so with the first row
  /// that is not recalled. Throws FailedError if the disk refuses it.
  void append(const std::string& phase, const Evaluation& e);
  /// At the end: the file is in its place, also if every row was recalled, and outlives a power cut.
  void finish() {
    file_.publish();
    file_.sync();
  }

 private:
  AppendFile file_;
  const Study& study_;
  std::vector<ExtraColumn> extra_;
  long count_ = 0;
};

}  // namespace armtune::internal
