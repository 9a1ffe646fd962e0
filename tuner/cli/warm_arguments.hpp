#pragma once
// The command line options for a warm start, which lets a search begin at the gains of an earlier run or of
// a file.

#include <string>
#include <vector>

#include "tuner/session/journalled_run.hpp"
#include "tuner/study/study.hpp"

namespace CLI {
class App;
}

namespace armtune::internal::cli {

/// The options as given. A zero or empty member leaves the study's own value.
struct WarmArguments {
  std::string from;                     ///< run folder or gains file with the gains to start from
  std::vector<std::string> parameters;  ///< names of the gains that are taken from it
  double box = 0.0;                     ///< width of the search range, as a share of each gain's range
  double step = 0.0;                    ///< initial step of the search, as a share of each gain's range
};

void add_warm_options(CLI::App& command, WarmArguments& args);

/// Replaces values of the study's warm_start by the options. Throws InputError if parameters, box or step are
/// given, but neither the command line nor the study has a warm start. Also throws if the resulting warm
/// start is not valid. A resumed run reads the gains from its own copy, because the run that they came from
/// may have been deleted.
void apply(WarmArguments args, const RunPlace& place, Study& study);

}  // namespace armtune::internal::cli
