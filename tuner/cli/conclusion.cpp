#include "tuner/cli/conclusion.hpp"

#include <fmt/format.h>

#include "tuner/cli/commands.hpp"
#include "tuner/cli/say.hpp"

namespace armtune::internal::cli {

int conclude(const SimulationVerdict& verdict) {
  say(fmt::format("\n{}", to_text(verdict)));
  return verdict.passed() ? kDone : kChecksFailed;
}

}  // namespace armtune::internal::cli
