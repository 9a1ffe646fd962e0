#pragma once
// Writes the file of `armtune robot --sidecar`: a robot YAML in which the user fills in values that a URDF
// lacks, or finds proposals for values that are doubtful.

#include <string>

#include "core/robot/urdf_reader.hpp"
#include "sim/scenario/robot_file.hpp"

namespace armtune::internal::cli {

/// Returns a text that lists what is missing or impossible, such as "velocity limit of a, b; inertia of c;
/// physically possible inertia of d (mass -2 kg)".
std::string named(const MissingData& missing);

/// Returns those data for which armtune has no proposal, so that the user must give them.
MissingData to_fill_in(const MissingData& missing);

/// Writes the new file `path`, and prints what to do with it. The file has a key for every value that is
/// missing or impossible, and proposals for doubtful values, as comments. If there are none of these, no file
/// is written.
/// Throws InputError if the file exists.
void write_sidecar(const RobotFile& file, const std::string& path);

}  // namespace armtune::internal::cli
