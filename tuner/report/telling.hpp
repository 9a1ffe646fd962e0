#pragma once
// Sorts scenarios by priority for a report page that has no room for all of them. Scenarios that failed come
// first.

#include <string>
#include <vector>

#include "tuner/report/report_data.hpp"

namespace armtune::internal::report {

/// Returns the indices of `names`: first the scenarios that failed with this gain set, then those that
/// broke a limit of the arm, then the others. Each group keeps its order.
std::vector<std::size_t> telling_order(const std::vector<std::string>& names,
                                       const std::vector<Table>& tables, std::size_t set);

}  // namespace armtune::internal::report
