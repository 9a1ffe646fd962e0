#pragma once
// Builds the plots and the 3D replay of a report page from one CSV file. The file records a rollout or a
// planned motion.

#include "tuner/report/buckets.hpp"
#include "tuner/report/recording.hpp"

namespace armtune::internal::report {

/// True for the columns that are plotted and are not a joint's: tool, errors, gaze and the like.
bool is_task_column(std::string_view name);

/// Returns the number in a cell as error messages show it. NaN is shown as an empty cell.
std::string shown_cell(double number);

/// A builder of a run from a CSV file. The run's time counts from the file's first row.
class RunBuilder {
 public:
  /// Sets the end and the time axis; the caller sets `start`. The table must outlive the builder. Throws
  /// InputError naming file and line if there are no times, or if a time is not a number within 1e9 s or is
  /// less than the one before.
  RunBuilder(const NumberTable& table, const Resolution& resolution);

  /// Returns the time of the first row [s], or 0 without rows. since() has the time of every row after it.
  double began() const { return time_.empty() ? 0.0 : time_.front(); }
  const std::vector<double>& since() const { return since_; }

  /// Adds a plot with one value per row.
  void add(const std::string& name, const std::string& group, const char* unit,
           const std::vector<double>& values);
  /// Adds plots of the columns that do not belong to a joint, if the file has them: tool, errors, gaze,
  /// distance from obstacles and the like.
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
