#pragma once
// Computes how much memory the recordings of rollouts need, from duration, control period and columns. If
// they do not fit, armtune refuses to record them before it simulates anything.

#include <vector>

#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// The purpose of recordings, which determines how many are in memory at once.
enum class RecordingUse {
  kWritten,  ///< each becomes a CSV file and is released; as many are in memory as there are workers
  kKept      ///< all of them stay in memory
};

/// Returns the bytes of memory that one scenario's recording takes. For kWritten this includes the making of
/// its CSV file. stride: control periods per row (>= 1).
double recording_bytes(const Scenario& scenario, int stride, RecordingUse use);

/// Returns the bytes of memory that this process may use: the machine's memory, or less where the shell
/// (ulimit -v), a container or a batch system sets a limit.
double usable_memory();

/// Throws InputError if the recordings that are in memory at once take more than `usable` bytes. It names the
/// scenario with the longest recording, its size, and the stride with which they fit.
void require_recording_memory(const std::vector<Scenario>& scenarios, int stride, int workers,
                              RecordingUse use = RecordingUse::kWritten, double usable = usable_memory());

}  // namespace armtune::internal
