#pragma once
// Turns the CSV file of a rollout into the plots and the replay of a report.

#include "sim/csv/number_table.hpp"
#include "tuner/report/report_data.hpp"
#include "tuner/report/scene.hpp"

namespace armtune::internal::report {

/// The resolution of a run's plots and replay. It decides how much of the page's size the run takes.
struct Resolution {
  std::size_t buckets = 700;  ///< number for each column of a plot, two values each
  double replay_rate = 25.0;  ///< [Hz]
};

/// Returns the smallest number of bytes of text that a run takes, for so many columns and so many series in
/// its replay.
std::size_t least_bytes(std::size_t columns, std::size_t replay_series);

/// Returns the finest resolution at which a run takes about `bytes` of text, but at least 50 buckets and 100
/// samples in all. columns, replay_series: numbers of columns and of series in the replay; seconds: duration
/// of the run [s].
Resolution resolution_for(std::size_t bytes, std::size_t columns, std::size_t replay_series, double seconds);

/// Reads the columns of a recording that plots and replay show. Throws InputError naming file and line.
NumberTable read_recording(const std::string& path);

/// Returns the names of the joints in the order of the recording's columns.
std::vector<std::string> joints_of(const NumberTable& rollout);

/// Makes a run with plots, states, slerps, end and replay. The caller sets `set`, `status` and `reason`.
/// scenario, arm: null if the run folder has no scene; then there are no joint columns and no replay. Throws
/// InputError naming the file if a column is missing, if times decrease, or if a state is not one of the
/// controller's.
Run run_of(const NumberTable& rollout, const SceneScenario* scenario, const Arm* arm,
           const Resolution& resolution);

}  // namespace armtune::internal::report
