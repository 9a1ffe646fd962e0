#include "tuner/cli/conclusion.hpp"

#include <fmt/format.h>

#include "sim/csv/text_file.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/say.hpp"

namespace armtune::cli {

void write_verdict(const std::string& folder, const SimulationVerdict& verdict) {
  if (!folder.empty()) write_text_file(folder + "/verdict.yaml", verdict_yaml(verdict));
}

int conclude(const SimulationVerdict& verdict) {
  say(fmt::format("\n{}", to_text(verdict)));
  return verdict.passed() ? kDone : kChecksFailed;
}

}  // namespace armtune::cli
