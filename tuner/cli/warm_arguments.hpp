#pragma once
// The command line options for a warm start, which lets a search begin at the gains of an earlier run or of
// a file.

#include <string>
#include <vector>

#include "tuner/study/study.hpp"

namespace CLI {
class App;
}

namespace armtune::internal::cli {

/// The options as given. A zero or empty member leaves the study's own value.
struct WarmArguments {
  std::string from;
  std::vector<std::string> parameters;
  double box = 0.0;
  double step = 0.0;
};

void add_warm_options(CLI::App& command, WarmArguments& args);

/// Replaces values of the study's warm_start by the options. Throws InputError if options change a warm start
/// that neither the command line nor the study gives, or if the warm start is not valid.
void apply(const WarmArguments& args, Study& study);

}  // namespace armtune::internal::cli
