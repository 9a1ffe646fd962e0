#pragma once
// Records which recordings of a robot a run read.

#include <string>

#include "tuner/run/write_run_record.hpp"

namespace armtune::internal {

/// Adds a log with its hash, or each file of a folder of rosbag2.
void add_log(const std::string& log, FilesRead& files);

}  // namespace armtune::internal
