#pragma once
// Warm starts on the command line and in a run folder.

#include <string>
#include <vector>

#include "tuner/study/study.hpp"

namespace CLI {
class App;
}

namespace armtune::cli {

/// Where a run folder keeps the gains a warm start began with.
inline constexpr const char* kWarmGains = "start/warm_gains.yaml";

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

/// A line on stderr for every gain that the study's bounds do not let begin where it was.
void warn_of_clamped(const Study& study);

/// Keeps the warm start's gains in a run folder that has its start/ already. Returns the file, as study.yaml
/// there names it; empty without a warm start.
std::string write_warm(const Study& study, const std::string& folder);

}  // namespace armtune::cli
