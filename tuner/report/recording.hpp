#pragma once
// Converts the CSV file of a recorded rollout into the plots and the 3D replay of a report page.

#include "sim/csv/number_table.hpp"
#include "tuner/report/report_data.hpp"
#include "tuner/report/scene.hpp"

namespace armtune::internal::report {

/// The resolution of a run's plots and replay. A finer resolution takes more bytes of the page.
struct Resolution {
  std::size_t buckets = 700;  ///< number of buckets (buckets.hpp) of a plotted column; two values each
  double replay_rate = 25.0;  ///< samples of the replay per second [Hz]
};

/// Returns the number of bytes of text that a run takes at the coarsest resolution, with 50 buckets and with
/// 100 samples in the replay. columns: number of plotted columns; replay_series: number of series in the
/// replay.
std::size_t least_bytes(std::size_t columns, std::size_t replay_series);

/// Returns the finest resolution at which a run takes about `bytes` bytes of text. It is never coarser than
/// the resolution that least_bytes assumes. columns, replay_series: as in least_bytes; seconds: duration of
/// the run [s].
Resolution resolution_for(std::size_t bytes, std::size_t columns, std::size_t replay_series, double seconds);

/// Reads those columns of a recording that the plots and the replay need. Throws InputError naming file and
/// line.
NumberTable read_recording(const std::string& path);

/// Returns the names of the joints in the order of the recording's columns.
std::vector<std::string> joints_of(const NumberTable& rollout);

/// Returns a run with its plots, states, slerps (smooth changes of the tool's orientation), end and replay.
/// The caller sets `set`, `status` and `reason`. scenario, arm: null if the run folder has no scene; then
/// there are no joint columns and no replay. Throws InputError naming the file if a column is missing, if
/// times decrease, or if a number in the column `state` is not a state of the controller.
Run run_of(const NumberTable& rollout, const SceneScenario* scenario, const Arm* arm,
           const Resolution& resolution);

}  // namespace armtune::internal::report
