#include "tuner/cli/sensitivity_report.hpp"

#include <fmt/format.h>

#include "tuner/cli/gain_tables.hpp"
#include "tuner/cli/say.hpp"

namespace armtune::internal::cli {

void print_sensitivity(const Study& study, const Sensitivity& sensitivity, std::size_t most) {
  say(sensitivity_table(study, sensitivity, most));
  if (most < sensitivity.parameters.size()) {
    say(fmt::format("  and {} more in sensitivity.csv\n", sensitivity.parameters.size() - most));
  }
  say(
      fmt::format("importance: increase of the merit (objective plus penalties; less is better) if\n"
                  "this gain alone returns to its start value; local: largest relative change of\n"
                  "the merit for a step of {:.0f} % of the gain's range\n\n",
                  100.0 * kSensitivityStep));
}

void print_advice(const Study& study, const Sensitivity& sensitivity) {
  for (const std::string& line : advice(study, sensitivity)) say(fmt::format("note: {}\n", line));
}

}  // namespace armtune::internal::cli
