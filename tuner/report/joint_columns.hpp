#pragma once
// Names of joints in the header of a CSV file of a run, such as joint/elbow/rms.

#include <string>
#include <string_view>
#include <vector>

#include "sim/csv/number_table.hpp"

namespace armtune::internal::report {

/// Returns the names between "joint/" and the ending in the header, in its order; at most 64.
std::vector<std::string> joints_with(const NumberTable& table, std::string_view ending);

}  // namespace armtune::internal::report
