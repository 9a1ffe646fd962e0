#pragma once
// The option --max-stiffness, and its use for a study that exists already.

#include <vector>

#include "tuner/study/study.hpp"

namespace CLI {
class App;
}

namespace armtune::internal::cli {

/// Adds the option. Its numbers are those of bound_stiffness.
void add_stiffness_option(CLI::App& command, std::vector<double>& most);

/// Tunes the stiffness of the study's controller up to `most` (bound_stiffness). If `most` is empty, prints
/// note_on_stiffness(study) on one line if it has a text. Ranks other than 0 print nothing.
void apply_stiffness(const std::vector<double>& most, Study& study);

}  // namespace armtune::internal::cli
