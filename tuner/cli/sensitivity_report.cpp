#include "tuner/cli/sensitivity_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tuner/cli/say.hpp"

namespace armtune::internal::cli {

void print_sensitivity(const Study& study, const Sensitivity& sensitivity, std::size_t most) {
  say(fmt::format("{:<38}{:>10}{:>10}{:>12}{:>10}\n", "gain, most important first", "start", "best",
                  "importance", "local"));
  const std::size_t shown = std::min(most, sensitivity.parameters.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const ParameterSensitivity& s = sensitivity.parameters[i];
    const Parameter& p = study.space.free[s.parameter];
    say(fmt::format("{:<38}{:>10.4g}{:>10.4g}{:>12.4f}{:>10}\n", p.entry.name, p.start, s.best, s.importance,
                    fmt::format("{:.2f} %", 100.0 * s.local)));
  }
  if (shown < sensitivity.parameters.size()) {
    say(fmt::format("  and {} more in sensitivity.csv\n", sensitivity.parameters.size() - shown));
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
