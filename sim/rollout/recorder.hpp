#pragma once
// A recorder that keeps every k-th period of a rollout and writes them as CSV.

#include <string>

#include "sim/rollout/columns.hpp"

namespace armtune::internal {

class Recorder {
 public:
  /// Keeps every `stride`-th period (>= 1), the first one included. Columns that summarize periods (Over) put
  /// the periods between two rows into the second one.
  Recorder(const Scenario& scenario, int stride);

  bool operator()(const Observation& o);

  /// Returns the values row by row, one per column, with one row per kept period. Columns that summarize
  /// periods put those after the last row into that row. completed: if false, the last period has a row of
  /// its own instead, because that period shows why the rollout failed.
  std::vector<double> rows(bool completed = true) &&;
  std::vector<double> rows(bool completed = true) const& { return Recorder(*this).rows(completed); }

  /// Writes rollout_<scenario>.csv: a header row, then `rows`. Numbers read back to the same bits. A value
  /// that is not finite is an empty cell. Throws InputError if the file cannot be written.
  void write_csv(const std::string& path, bool completed = true) const;

  const std::vector<Column>& columns() const { return columns_; }

 private:
  std::vector<Column> columns_;
  int stride_;
  long seen_ = 0;
  std::vector<double> row_;     ///< the last period, summarized with those since the row before
  std::vector<double> values_;  ///< row by row
};

}  // namespace armtune::internal
