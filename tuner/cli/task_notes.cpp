#include "tuner/cli/task_notes.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "sim/scenario/path_walk.hpp"

namespace armtune::cli {

void warn_of_task(const Scenario& scenario, const Gains& gains) {
  const std::string trouble = task_trouble(scenario, gains);
  if (!trouble.empty()) fmt::print(stderr, "armtune: warning: {}: {}\n", scenario.name, trouble);
}

}  // namespace armtune::cli
