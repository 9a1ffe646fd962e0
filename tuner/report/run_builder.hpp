#pragma once
// What plots and a replay show of a rollout and of a plan alike.

#include "tuner/report/buckets.hpp"
#include "tuner/report/recording.hpp"

namespace armtune::internal::report {

/// True for the columns that are plotted and are not a joint's: tool, errors, gaze and the like.
bool is_task_column(std::string_view name);

/// Returns a cell's number as a message shows it; NaN is what an empty cell is read as.
std::string shown_cell(double number);

/// A run being made from a CSV, whose time counts from its first row.
class RunBuilder {
 public:
  /// End and time axis; start is the caller's. table must outlive it. Throws InputError naming file and line
  /// if it has no times, or if one is not a number within 1e9 s, or is less than the one before.
  RunBuilder(const NumberTable& table, const Resolution& resolution);

  /// Time of the first row [s], 0 without rows; and of every row since.
  double began() const { return time_.empty() ? 0.0 : time_.front(); }
  const std::vector<double>& since() const { return since_; }

  /// A plot of one value per row.
  void add(const std::string& name, const std::string& group, const char* unit,
           const std::vector<double>& values);
  /// Plots of the columns that are not a joint's: tool, errors, gaze, distance from obstacles and the like,
  /// as far as the file has them.
  void add_task_columns();
  /// The replay, where there is a scene and at least one row. Throws InputError naming the file if a joint's
  /// column is missing.
  void add_replay(const SceneScenario* scenario, const Arm* arm);

  Run run;  ///< as far as it is made

 private:
  const NumberTable& table_;
  std::vector<double> time_, since_;
  Buckets buckets_;
  double replay_rate_;
};

}  // namespace armtune::internal::report
