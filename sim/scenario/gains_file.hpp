#pragma once
// Gains in YAML, field for field the published names, so that a ROS parameter file of such a controller loads
// as it is.

#include <string>
#include <vector>

#include "core/control/gains.hpp"

namespace armtune {

/// Reads bundled gains by name, or a file by path. `controller: NAME` says whose they are; without it they
/// are the adaptive one's. The fields stand at the top or under one key of any name (the published
/// `simple_effort_ctrl`). The path of the published file (circularTrajectory*) is accepted and not used: the
/// scenario says where the tool goes. Validated. Throws InputError.
Gains load_gains(const std::string& name_or_path, const std::vector<std::string>& joints,
                 const std::string& relative_to = {});

/// The gains as such a file; numbers read back to the same bits. `header`: comment lines without '#'.
std::string gains_yaml(const Gains& gains, const std::vector<std::string>& header);

}  // namespace armtune
