#include "tuner/cli/tune_printer.hpp"

#include <fmt/format.h>

#include "tuner/cli/endurance_option.hpp"
#include "tuner/cli/gain_tables.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/sensitivity_report.hpp"
#include "tuner/search/last_steps.hpp"
#include "tuner/search/sweep.hpp"
#include "tuner/session/study_files.hpp"

namespace armtune::internal::cli {

void TunePrinter::began(const Study& study, std::size_t recalled) {
  const std::string& folder = settings_.place.folder;
  if (settings_.live) say(fmt::format("to watch the search, open {}/report.html in a browser\n", folder));
  say(fmt::format(
      "study {}: {} gains, {} scenarios{}{}. Search: {}; engine: {}; budget: {}, {} rollouts per evaluation. "
      "Results go to {}\n",
      study.name, study.space.free.size(), study.scenarios.size(), robust_text(study),
      study.margins.empty() ? "" : fmt::format(", {} stability margins as constraints", study.margins.size()),
      search_text(study), engine_text(engine_of_search(study)),
      budget_text(study.max_evaluations, study.max_minutes), rollouts_per_evaluation(study), folder));
  const auto swept = static_cast<long>(sweep_points(study).size());
  const long room = evaluations_to_search(study);
  if (swept > 0 && swept >= room) {
    say(fmt::format(
        "the sweep's {} points take all evaluations of the budget: {}; allow more evaluations, or give fewer "
        "sweep factors\n",
        swept,
        swept > room ? fmt::format("only {} of them are simulated", room)
                     : "no evaluation is left for the search"));
  }
  if (settings_.place.resume) say(fmt::format("resuming after {} finished evaluations\n", recalled));
  std::fflush(stdout);
}

void TunePrinter::verified(const TuneOutcome& so_far) {
  if (!so_far.robust.empty()) {
    say(fmt::format("Metrics over all arms of the study{}:\n\n{}The nominal arm alone:\n\n",
                    robust_text(study_), comparison_table(so_far.robust, headline_metrics())));
  }
  say(comparison_table(so_far.sets, headline_metrics()));
  say(gains_table(study_, so_far.result) + "\n");
}

void TunePrinter::found_margins(const std::vector<ComparedMargins>& sets) {
  say(fmt::format("{}\n", margins_table(study_.scenarios, sets)));
}

void TunePrinter::found_sensitivity(const Sensitivity& sensitivity) {
  print_sensitivity(study_, sensitivity, kMostShown);
  print_advice(study_, sensitivity);
}

/// Prints how the search ended: the best objective, the largest joint velocity and the violated constraints.
void TunePrinter::searched(const TuneOutcome& so_far) {
  const TuneResult& result = so_far.result;
  const Objective& objective = *so_far.objective;
  say(fmt::format("{}: objective {:.4f} (start gains 1{}) after {} evaluations; {}\n", study_.name,
                  result.best.objective,
                  result.best_of_sweep
                      ? fmt::format(", best of the coarse sweep {:.4f}{}", result.best_of_sweep->objective,
                                    result.best_of_sweep->feasible ? "" : ", not feasible")
                      : "",
                  result.evaluations, result.reason));
  say(fmt::format("largest joint velocity {:.4f} of its limit{}; {}\n",
                  largest_velocity_ratio(study_, result.best), robust_text(study_),
                  result.best.feasible ? "every constraint holds" : "NOT feasible:"));
  if (result.best.feasible) return;
  if (!result.best.completed) say(fmt::format("  {}\n", result.best.reason));
  for (std::size_t c = 0; c < objective.constraints().size(); ++c) {
    if (result.best.constraints[c] > 0.0) {
      say(fmt::format("  {} is violated by {:.4g}\n", objective.constraint_name(c),
                      result.best.constraints[c]));
    }
  }
}

void TunePrinter::extended(const std::vector<EnduranceResult>& results) {
  say_how_extended(study_.scenarios);
  if (results.size() < study_.scenarios.size()) return;
  say(fmt::format("Every scenario extended to at least {:.4g} minutes:\n{}\n", study_.thresholds.minutes,
                  endurance_table(results)));
}

}  // namespace armtune::internal::cli
