#pragma once
// Writes the file of `armtune robot --sidecar`: a robot YAML in which the user fills in values that a URDF
// lacks, or finds proposals for values that are doubtful.

#include <string>

#include "core/robot/urdf_reader.hpp"
#include "sim/scenario/robot_file.hpp"

namespace armtune::internal::cli {

/// Returns what is missing as text, such as "velocity limit of a, b; inertia of c".
std::string named(const MissingData& missing);

/// Writes the new file `path`, and prints what to do with it. The file has a key for every missing value. If
/// no value is missing, it has proposals for doubtful values, as comments. If none is doubtful either, no
/// file is written.
/// Throws InputError if the file exists.
void write_sidecar(const RobotFile& file, const MissingData& missing, const std::string& path);

}  // namespace armtune::internal::cli
