#pragma once
// A rollout's CSV as plots and a replay show it.

#include "sim/csv/number_table.hpp"
#include "tuner/report/report_data.hpp"
#include "tuner/report/scene.hpp"

namespace armtune::internal::report {

/// How fine: what one run may take of the page's size.
struct Resolution {
  std::size_t buckets = 700;  ///< of each plot's column, two values each
  double replay_rate = 25.0;  ///< [Hz]
};

/// Bytes of text that a run takes at least, with so many columns and series in its replay.
std::size_t least_bytes(std::size_t columns, std::size_t replay_series);

/// The finest resolution at which a run of `seconds` with so many columns and series in its replay takes
/// about `bytes` of text; no less than 50 buckets and 100 samples in all.
Resolution resolution_for(std::size_t bytes, std::size_t columns, std::size_t replay_series, double seconds);

/// Reads a recording: of its columns those that plots and replay show. Throws InputError naming file and
/// line.
NumberTable read_recording(const std::string& path);

/// Names of the joints in the order of a recording's columns.
std::vector<std::string> joints_of(const NumberTable& rollout);

/// Plots, states, slerps, end and replay; set, status and reason are the caller's. scenario, arm: null where
/// the run folder has no scene; then without torques over their limits, and without a replay. Throws
/// InputError naming the file if a column is missing, if times fall or a state is none of the controller's.
Run run_of(const NumberTable& rollout, const SceneScenario* scenario, const Arm* arm,
           const Resolution& resolution);

}  // namespace armtune::internal::report
