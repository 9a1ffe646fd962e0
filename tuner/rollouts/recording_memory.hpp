#pragma once
// The memory that recordings of rollouts need. It follows from duration, control period and columns, so that
// a recording that does not fit is refused before it begins.

#include <vector>

#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// The use of recordings.
enum class RecordingUse {
  kWritten,  ///< each becomes a CSV file and is released; as many are in memory as there are workers
  kKept      ///< all of them stay in memory
};

/// Returns the bytes of memory that one scenario's recording takes, while its CSV file is made if it is
/// written. stride: control periods per row (>= 1).
double recording_bytes(const Scenario& scenario, int stride, RecordingUse use);

/// Returns the bytes of memory that this process may use: the machine's memory, or less where the shell
/// (ulimit -v), a container or a batch system sets a limit.
double usable_memory();

/// Throws InputError if the recordings that are in memory at once take more than `usable` bytes. It names the
/// scenario with the longest recording, its size, and the stride with which they fit.
void require_recording_memory(const std::vector<Scenario>& scenarios, int stride, int workers,
                              RecordingUse use = RecordingUse::kWritten, double usable = usable_memory());

}  // namespace armtune::internal
