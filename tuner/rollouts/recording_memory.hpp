#pragma once
// Computes how much memory the recordings of rollouts need. If they do not fit in memory, armtune reports an
// error before it simulates anything.

#include <vector>

#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// The use of recordings. It determines how many recordings are in memory at the same time.
enum class RecordingUse {
  kWritten,  ///< each is written to a CSV file and then released; at most one per worker is in memory
  kKept      ///< all recordings stay in memory
};

/// Returns the number of bytes that one scenario's recording takes in memory. It follows from the duration,
/// the control period and the number of columns. For kWritten it includes the memory that is needed to write
/// the CSV file. stride: control periods per row (>= 1).
double recording_bytes(const Scenario& scenario, int stride, RecordingUse use);

/// Returns the number of bytes of memory that recordings may use. This is the machine's memory, or less if a
/// container or a batch system sets a limit. If the shell sets a limit (ulimit -v), the result is the part of
/// this limit that the process does not use yet, minus a reserve of 64 MB.
double usable_memory();

/// Throws InputError if the recordings that are in memory at the same time take more than `usable` bytes. The
/// message gives the largest recording with its scenario and size, and a stride with which all would fit.
void require_recording_memory(const std::vector<Scenario>& scenarios, int stride, int workers,
                              RecordingUse use = RecordingUse::kWritten, double usable = usable_memory());

}  // namespace armtune::internal
