#pragma once
// Which scenarios of very many a page shows first.

#include <string>
#include <vector>

#include "tuner/report/report_data.hpp"

namespace armtune::internal::report {

/// Indices of `names`, those first that failed with the set, then those that broke a limit of the arm, then
/// the others; each in their order.
std::vector<std::size_t> telling_order(const std::vector<std::string>& names,
                                       const std::vector<Table>& tables, std::size_t set);

}  // namespace armtune::internal::report
