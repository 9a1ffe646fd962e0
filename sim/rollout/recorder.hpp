#pragma once
// Keeps every k-th period of a rollout and writes it as CSV.

#include <string>

#include "sim/rollout/columns.hpp"

namespace armtune::internal {

class Recorder {
 public:
  /// Keeps every `stride`-th period (>= 1), the first one included; what columns say of the periods between
  /// goes into the row after them.
  Recorder(const Scenario& scenario, int stride);

  bool operator()(const Observation& o);

  /// Row by row a value for each column, one row per kept period. What columns say of the periods behind the
  /// last of them goes into its row. completed: otherwise the last period has a row of its own, since it is
  /// where a rollout that failed shows why.
  std::vector<double> rows(bool completed = true) &&;
  std::vector<double> rows(bool completed = true) const& { return Recorder(*this).rows(completed); }

  /// rollout_<scenario>.csv: a header row, then `rows`. Numbers read back to the same bits; what is not
  /// finite is an empty cell. Throws InputError if it cannot be written.
  void write_csv(const std::string& path, bool completed = true) const;

  const std::vector<Column>& columns() const { return columns_; }

 private:
  std::vector<Column> columns_;
  int stride_;
  long seen_ = 0;
  std::vector<double> row_;     ///< of the period seen last, and of those since the row before
  std::vector<double> values_;  ///< row by row
};

}  // namespace armtune::internal
