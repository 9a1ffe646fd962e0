#pragma once
// Prints how much each gain mattered in a finished search, for `armtune tune` and `armtune sensitivity`.

#include "tuner/sensitivity/sensitivity.hpp"

namespace armtune::internal::cli {

/// Prints at most `most` gains, the most important first, with the effect of each.
void print_sensitivity(const Study& study, const Sensitivity& sensitivity, std::size_t most);

/// Prints advice in plain words: which gains ended at a bound of their range, which gains have no effect, and
/// what to change.
void print_advice(const Study& study, const Sensitivity& sensitivity);

}  // namespace armtune::internal::cli
