#pragma once
// Tables of gains for a terminal, one gain in each line.

#include <string>

#include "tuner/search/tune.hpp"
#include "tuner/sensitivity/sensitivity.hpp"

namespace armtune::internal::cli {

/// Returns a table of the gains that a search found, beside the start gains.
std::string gains_table(const Study& study, const TuneResult& result);

/// Returns a table of at most `most` gains, the most important first, with the effect of each.
std::string sensitivity_table(const Study& study, const Sensitivity& sensitivity, std::size_t most);

}  // namespace armtune::internal::cli
