#include "tuner/cli/rollouts_printer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tuner/cli/conclusion.hpp"
#include "tuner/cli/endurance_option.hpp"
#include "tuner/cli/say.hpp"

namespace armtune::internal::cli {

void print_simulated(const SimulateOutcome& outcome, const RolloutSettings& settings,
                     const std::string& gains) {
  if (outcome.endured) say_how_extended(settings.scenarios);
  double simulated = 0.0;
  for (const ScenarioResult& r : outcome.results) simulated += r.result.end_time;
  say(comparison_table({{gains, outcome.results}}, all_metrics()) +
      fmt::format("{:.4g} s simulated in {:.3g} s: {:.3g} times real time on {} workers\n", simulated,
                  outcome.seconds, simulated / outcome.seconds, settings.workers));
  if (outcome.endured) {
    say(fmt::format("\nEvery scenario extended to at least {:.4g} minutes:\n{}", settings.endurance,
                    endurance_table(*outcome.endured)));
  }
  if (!settings.folder.empty())
    say(fmt::format("wrote {}: {}\n", settings.folder, fmt::join(outcome.files, ", ")));
  if (outcome.ending != Ending::kInterrupted) conclude(outcome.verdict);
}

void print_compared(const CompareOutcome& outcome, const RolloutSettings& settings,
                    const std::vector<Metric>& metrics) {
  if (outcome.sets.empty()) {
    fmt::print(stderr, "interrupted: the comparison is not complete, so nothing was written\n");
    return;
  }
  for (const auto& endured : outcome.endured) {
    if (endured) say_how_extended(settings.scenarios);
  }
  say(comparison_table(outcome.sets, metrics));
  for (std::size_t i = 0; i < outcome.sets.size(); ++i) {
    if (!outcome.endured[i]) continue;
    say(fmt::format("{}, every scenario extended to at least {:.4g} minutes:\n{}\n", outcome.sets[i].name,
                    settings.endurance, endurance_table(*outcome.endured[i])));
  }
  if (!settings.folder.empty())
    say(fmt::format("wrote {}: {}\n", settings.folder, fmt::join(outcome.files, ", ")));
  if (outcome.ending != Ending::kInterrupted) {
    conclude(outcome.verdict);
    return;
  }
  say("interrupted: the gain sets were compared, but not all scenarios were extended; there is no verdict\n");
}

}  // namespace armtune::internal::cli
