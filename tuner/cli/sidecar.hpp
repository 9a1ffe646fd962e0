#pragma once
// The robot YAML that `armtune robot --sidecar` writes: for values that are missing, or doubtful.

#include <string>

#include "core/robot/urdf_reader.hpp"
#include "sim/scenario/robot_file.hpp"

namespace armtune::internal::cli {

/// Returns what is missing as text, such as "velocity limit of a, b; inertia of c".
std::string named(const MissingData& missing);

/// Writes the new file `path` and says what to do with it. It has a place for every missing value. If no
/// value is missing, it has proposals for doubtful values as comments; without doubts it is not written.
/// Throws InputError if the file exists.
void write_sidecar(const RobotFile& file, const MissingData& missing, const std::string& path);

}  // namespace armtune::internal::cli
