#include "tuner/cli/endurance_option.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>

#include "tuner/cli/say.hpp"

namespace armtune::internal::cli {

CLI::Option* add_endurance_option(CLI::App& command, double& minutes) {
  return command
      .add_option("--endurance", minutes,
                  "extend every scenario to this many simulated minutes and report the first limit that is "
                  "broken (without a value: 30 simulated minutes, which take seconds to compute)")
      ->expected(0, 1)
      ->default_str(fmt::format("{}", VerdictThresholds().minutes))
      ->option_text("[MINUTES]")
      ->check(CLI::Range(0.01, 1440.0));
}

void say_how_extended(const std::vector<Scenario>& scenarios) {
  for (const Scenario& scenario : scenarios) {
    for (const std::string& sentence : how_extended(scenario)) {
      say(fmt::format("{}, extended: {}\n", scenario.name, sentence));
    }
  }
}

std::string endurance_table(const std::vector<EnduranceResult>& results) {
  std::string text;
  for (const EnduranceResult& r : results) {
    text += fmt::format("  {:<40} ", r.scenario);
    if (r.broken) {
      text += to_string(*r.broken);
    } else if (!r.ended.empty()) {
      text += r.ended;
    } else {
      text += fmt::format("kept every limit for {:.4g} minutes", r.simulated / 60.0);
      if (!std::isnan(r.rms_growth)) {
        text += fmt::format(
            "; from the first to the last minutes, the RMS error changes by the factor {:.2f} and the peak "
            "error by the factor {:.2f}",
            r.rms_growth, r.peak_growth);
      }
    }
    text += fmt::format(" ({})\n", name(r.engine));
  }
  return text;
}

}  // namespace armtune::internal::cli
