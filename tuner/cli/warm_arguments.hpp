#pragma once
// Warm starts on the command line.

#include <string>
#include <vector>

#include "tuner/study/study.hpp"

namespace CLI {
class App;
}

namespace armtune::internal::cli {

/// As given; zero or empty: the study's own.
struct WarmArguments {
  std::string from;
  std::vector<std::string> parameters;
  double box = 0.0;
  double step = 0.0;
};

void add_warm_options(CLI::App& command, WarmArguments& args);

/// Lets the options stand over the study's warm_start. Throws InputError if there is none to refine.
void apply(const WarmArguments& args, Study& study);

}  // namespace armtune::internal::cli
