#pragma once
// The command line options that say how random arms differ from the model: widths of uniform distributions,
// or the file of a joint distribution.

#include <string>
#include <utility>
#include <vector>

#include "sim/scenario/perturbation.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace armtune::internal::cli {

/// The options as given.
struct UncertaintyArguments {
  Perturbation given;        ///< the widths that were given; the others have the defaults of Perturbation
  std::string distribution;  ///< path of the file with a joint distribution; empty: none
  std::vector<std::pair<const CLI::Option*, double Perturbation::*>> widths = {};  ///< each with its option
};

/// Adds the options to a command. args must outlive the parsing.
void add_uncertainty_options(CLI::App& command, UncertaintyArguments& args);

/// Returns the random changes of the scenarios' arm. Widths that were not given have the scenarios' defaults.
/// Throws InputError if the file of the distribution does not fit the arm.
Perturbation perturbation_of(const UncertaintyArguments& args, const std::vector<Scenario>& scenarios);

}  // namespace armtune::internal::cli
