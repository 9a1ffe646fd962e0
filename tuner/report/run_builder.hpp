#pragma once
// Builds the plots and the 3D replay of a report page from one CSV file. The file records a rollout or a
// planned motion.

#include "tuner/report/buckets.hpp"
#include "tuner/report/recording.hpp"

namespace armtune::internal::report {

/// True if the column with this name is plotted and does not belong to a joint. Such columns are the position
/// of the tool, its errors, the gaze angle and the like.
bool is_task_column(std::string_view name);

/// Returns the number in a cell as error messages show it. The text for NaN is "an empty cell".
std::string shown_cell(double number);

/// A builder of a run from a CSV file. The run's time counts from the file's first row.
class RunBuilder {
 public:
  /// Sets the end and the time axis of `run`; the caller sets `run.start`. The table must outlive the
  /// builder. Throws InputError naming the file if it has no column `time`. Throws InputError naming file and
  /// line if a time is not a number between -1e9 and 1e9 s, or if it is less than the time before.
  RunBuilder(const NumberTable& table, const Resolution& resolution);

  /// Returns the time of the first row [s], or 0 if there are no rows.
  double began() const { return time_.empty() ? 0.0 : time_.front(); }
  /// Returns the time of every row, counted from the first row [s].
  const std::vector<double>& since() const { return since_; }

  /// Adds a column to a plot. group: name of the plot; values: one per row.
  void add(const std::string& name, const std::string& group, const char* unit,
           const std::vector<double>& values);
  /// Adds all columns of the file for which is_task_column() is true.
  void add_task_columns();
  /// Adds the replay if there is a scene and at least one row. Throws InputError naming the file if a joint's
  /// column is missing.
  void add_replay(const SceneScenario* scenario, const Arm* arm);

  Run run;  ///< the run as far as it is built

 private:
  const NumberTable& table_;
  std::vector<double> time_, since_;
  Buckets buckets_;
  double replay_rate_;
};

}  // namespace armtune::internal::report
