#pragma once
// Prints how much each gain mattered in a finished search, for `armtune tune` and `armtune sensitivity`.

#include "tuner/sensitivity/sensitivity.hpp"

namespace armtune::internal::cli {

/// Prints the `most` most important gains, most important first, with the effect of each.
void print_sensitivity(const Study& study, const Sensitivity& sensitivity, std::size_t most);

/// Prints, in plain words, bounds that were hit and gains without effect.
void print_advice(const Study& study, const Sensitivity& sensitivity);

}  // namespace armtune::internal::cli
