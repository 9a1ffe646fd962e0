#pragma once
// Records the time series of a rollout (one simulated scenario), with one row for every k-th control period,
// and writes it as CSV.

#include <string>

#include "sim/rollout/columns.hpp"

namespace armtune::internal {

class Recorder {
 public:
  /// Keeps a row for the first control period and then for every `stride`-th (>= 1). A column with the
  /// largest or smallest value (Over) also covers the periods since the previous row.
  Recorder(const Scenario& scenario, int stride);

  /// Records one control period. It is an Observer and always returns true.
  bool operator()(const Observation& o);

  /// Returns the values row by row, one per column. completed: true if the rollout ran to its end. In the
  /// last row, the columns with the largest or smallest value then also cover the periods after this row. If
  /// the rollout did not complete, its last period gets a row of its own, because it shows what went wrong.
  std::vector<double> rows(bool completed = true) &&;
  std::vector<double> rows(bool completed = true) const& { return Recorder(*this).rows(completed); }

  /// Writes the CSV file of the rollout: a header row, then `rows`. Numbers read back to the same bits. A
  /// value that is not finite is an empty cell. Throws InputError if the file cannot be written.
  void write_csv(const std::string& path, bool completed = true) const;

  const std::vector<Column>& columns() const { return columns_; }

 private:
  std::vector<Column> columns_;
  int stride_;
  long seen_ = 0;
  std::vector<double> row_;     ///< summary of the periods since the previous row
  std::vector<double> values_;  ///< row by row
};

}  // namespace armtune::internal
