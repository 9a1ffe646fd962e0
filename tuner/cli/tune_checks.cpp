#include "tuner/cli/tune_checks.hpp"

#include <fmt/format.h>

#include "tuner/cli/endurance_option.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/progress_line.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/verdict/assumptions.hpp"
#include "tuner/verdict/rollout_checks.hpp"

namespace armtune::cli {
namespace {

/// Adds margins, random arms and endurance; names those that an interruption left out.
void add_deep_checks(const Study& study, const Gains& gains, int workers, SimulationVerdict& verdict) {
  ProgressLine line;
  DeepCheckOptions how;
  how.workers = workers;
  how.progress = [&line](const std::string& what, std::size_t done, std::size_t all) {
    line.show(fmt::format("checks: {}, {} of {}", what, done, all));
  };
  const auto& stop = stop_requested();
  if (!add_margin_checks(study, gains, how, stop, verdict))
    verdict.not_checked.emplace_back("stability margins (interrupted)");
  if (!add_yield_check(study, gains, how, stop, verdict))
    verdict.not_checked.emplace_back("arms that differ from the model (interrupted)");
  line.clear();
  if (study.thresholds.minutes <= 0.0) {
    verdict.not_checked.emplace_back("endurance (its threshold is zero minutes)");
    return;
  }
  const auto endured = run_endurance(
      study.scenarios, [&gains](const Scenario&) { return gains; },
      {study.thresholds.minutes, study.stepper, workers, {}}, "checks");
  if (endured.size() < study.scenarios.size()) {
    verdict.not_checked.emplace_back("endurance (interrupted)");
    return;
  }
  say(fmt::format("Every scenario extended to at least {:.4g} minutes:\n{}\n", study.thresholds.minutes,
                  endurance_table(endured)));
  add_endurance_checks(endured, study.thresholds, "", verdict);
}

}  // namespace

SimulationVerdict check_search(const Study& study, const TuneResult& result, const Objective& objective,
                               const ComparedSet& simulated, bool deep, int workers) {
  SimulationVerdict verdict;
  add_search_checks(study, result, objective, verdict);
  add_rollout_checks(simulated.results, "", verdict);
  add_contact_check(study.scenarios, simulated.results, "", verdict);
  if (deep) {
    add_deep_checks(study, result.best.gains, workers, verdict);
  } else {
    for (const char* what :
         {"stability margins", "arms that differ from the model", "what happens after the scenarios end"}) {
      verdict.not_checked.emplace_back(what);
    }
  }
  verdict.not_checked.insert(verdict.not_checked.end(), never_checked().begin(), never_checked().end());
  add_assumptions(study.scenarios, study.stepper, verdict);
  verdict.notes = loosened(study.thresholds);
  add_bounds_note(study, result.best.gains, verdict);
  return verdict;
}

void print_recommendation(const TuneResult& result, const Check& constraints, const std::string& folder) {
  const SearchOutcome outcome = outcome_of(result);
  if (outcome == SearchOutcome::kTuned) return;
  if (outcome == SearchOutcome::kStart) {
    say(fmt::format(
        "The search found nothing better than the start gains, so {0}/gains.yaml holds the start gains.\n"
        "{1}Allow more evaluations, or give the parameters other bounds.\n",
        folder,
        constraints.passed
            ? ""
            : fmt::format("They break a constraint: do not load them on the robot. In the way: {}.\n"
                          "Recommended for a further search: the start gains. ",
                          to_text(constraints))));
    return;
  }
  say(fmt::format("Nothing feasible was found. In the way: {}.\n", to_text(constraints)));
  if (result.best.objective <= 1.0) {
    say(fmt::format(
        "{0}/gains.yaml holds the point with the least violation. It breaks a constraint: do not load it "
        "on the robot. Recommended for a further search: the least violation (--warm-start {0}).\n",
        folder));
  } else {
    say(fmt::format(
        "{0}/gains.yaml holds the point with the least violation, whose objective is {1:.3g} times the "
        "start's. The start gains ({0}/start/gains.yaml) break a constraint too: load neither on the robot. "
        "Recommended for a further search, with more evaluations: the start gains.\n",
        folder, result.best.objective));
  }
}

}  // namespace armtune::cli
