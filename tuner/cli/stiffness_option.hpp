#pragma once
// The option --max-stiffness, which sets the largest stiffness that a search may give to an impedance
// controller, for a study that exists already.

#include <vector>

#include "tuner/study/study.hpp"

namespace CLI {
class App;
}

namespace armtune::internal::cli {

/// Adds the option, which writes its numbers into `most`. bound_stiffness (stiffness_bounds.hpp) gives their
/// meaning.
void add_stiffness_option(CLI::App& command, std::vector<double>& most);

/// Adds the stiffness of the study's controller, with the upper bounds `most`, to the tuned gains
/// (bound_stiffness). If `most` is empty, the stiffness is not added. Prints note_on_stiffness(study) if that
/// is not empty. Ranks other than 0 print nothing.
void apply_stiffness(const std::vector<double>& most, Study& study);

}  // namespace armtune::internal::cli
