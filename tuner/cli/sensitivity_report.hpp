#pragma once
// What a finished run says of its gains: shared by `tune` and `sensitivity`.

#include "tuner/sensitivity/sensitivity.hpp"

namespace armtune::internal::cli {

/// The gains from the most to the least important, `most` of them, with what each does.
void print_sensitivity(const Study& study, const Sensitivity& sensitivity, std::size_t most);

/// Bounds that were hit and gains without effect, in plain words.
void print_advice(const Study& study, const Sensitivity& sensitivity);

}  // namespace armtune::internal::cli
