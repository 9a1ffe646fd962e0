#pragma once
// Writes evaluations.csv, the table of a search's evaluations. An evaluation is one gain set, simulated in
// every scenario of the study. Its row is written as soon as the evaluation is finished.

#include <functional>
#include <string>
#include <vector>

#include "sim/rollout/columns.hpp"
#include "tuner/run/append_file.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {

/// A column in addition to those that follow from the study.
struct ExtraColumn {
  Column column;
  std::function<double(const Evaluation&)> value;
};

/// Returns name, unit and meaning of every column of a study's evaluations.csv.
std::vector<Column> evaluation_columns(const Study& study, const std::vector<ExtraColumn>& extra = {});

class EvaluationsFile {
 public:
  /// Creates the file with its header. Throws InputError if it cannot be created, or if it exists and must
  /// not be replaced.
  EvaluationsFile(const std::string& path, const Study& study, std::vector<ExtraColumn> extra = {},
                  AppendFile::Open open = AppendFile::Open::kNew);

  /// Appends one row and passes it to the operating system. Numbers have all digits that are needed to read
  /// back the same value. Only the wall time is rounded, to milliseconds. A missing value is an empty cell.
  /// The wall time is the last column, and the only one that differs between two runs of one study. With
  /// AppendFile::Open::kReplace, the older file is replaced at the first row that does not come from the
  /// journal. Throws FailedError if the disk refuses the row.
  void append(const std::string& phase, const Evaluation& e);
  /// Must be called at the end. It replaces an older file even if every row came from the journal, and makes
  /// the file survive a power cut.
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
