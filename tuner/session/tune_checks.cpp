// The simulation checks at the end of a tuning session.

#include <algorithm>

#include "sim/scenario/gains_file.hpp"
#include "tuner/session/study_files.hpp"
#include "tuner/session/tune_session.hpp"
#include "tuner/verdict/assumptions.hpp"
#include "tuner/verdict/rollout_checks.hpp"
#include "tuner/verdict/rotor_check.hpp"
#include "tuner/verdict/search_checks.hpp"

namespace armtune::internal {
namespace {

/// Adds margins, estimates and random arms; names those that an interruption left out.
void add_deep_checks(const Study& study, const Gains& gains, int workers, const std::atomic<bool>& stop,
                     TuneObserver& observer, SimulationVerdict& verdict) {
  DeepCheckOptions how;
  how.workers = workers;
  how.progress = [&observer](const std::string& what, std::size_t done, std::size_t all) {
    progress_of(observer, "checks: " + what)(done, all);
  };
  if (!add_margin_checks(study, gains, how, stop, verdict))
    verdict.not_checked.emplace_back("stability margins (interrupted)");
  if (!add_rotor_check(study, gains, how, stop, verdict))
    verdict.not_checked.emplace_back("other rotor inertia than the estimated one (interrupted)");
  if (!add_yield_check(study, gains, how, stop, verdict))
    verdict.not_checked.emplace_back("arms that differ from the model (interrupted)");
  observer.part_is_over();
}

}  // namespace

std::string TuneSession::breaks_later(const Gains& gains) {
  endured_with_ = gains_yaml(gains, {});
  endured_ = endure(
      study_.scenarios, [&gains](const Scenario&) { return gains; },
      {study_.thresholds.minutes, study_.stepper, settings_.workers,
       progress_of(observer_, "checks: scenarios extended")},
      context_.stop);
  observer_.part_is_over();
  if (endured_.size() < study_.scenarios.size()) return {};  // interrupted
  SimulationVerdict verdict;
  add_endurance_checks(endured_, study_.thresholds, "", verdict);
  const auto failed = std::find_if(verdict.checks.begin(), verdict.checks.end(),
                                   [](const Check& check) { return !check.passed; });
  return failed == verdict.checks.end() ? std::string() : to_text(*failed);
}

/// What the search has looked at already is not simulated again.
void TuneSession::check_endurance() {
  SimulationVerdict& verdict = outcome_.verdict;
  if (study_.thresholds.minutes <= 0.0) {
    verdict.not_checked.emplace_back("endurance (its threshold is zero minutes)");
    return;
  }
  const Gains& gains = outcome_.result.best.gains;
  if (endured_with_ != gains_yaml(gains, {})) breaks_later(gains);
  observer_.extended(endured_);
  if (endured_.size() < study_.scenarios.size()) {
    verdict.not_checked.emplace_back("endurance (interrupted)");
    return;
  }
  add_endurance_checks(endured_, study_.thresholds, "", verdict);
}

/// Makes every check of the search's result: constraints, the start, the arm's own limits in the study's
/// scenarios and, where it was analysed, margins, random arms and endurance. What was left out stands under
/// "Not checked".
void TuneSession::check(bool analysed) {
  const TuneResult& result = outcome_.result;
  SimulationVerdict& verdict = outcome_.verdict;
  add_search_checks(study_, result, *outcome_.objective, verdict);
  add_rollout_checks(outcome_.sets[1].results, "", verdict);
  add_contact_checks(study_.scenarios, outcome_.sets[1].results, "", verdict);
  if (analysed) {
    add_deep_checks(study_, result.best.gains, settings_.workers, context_.stop, observer_, verdict);
    check_endurance();
  } else {
    for (const char* what :
         {"stability margins", "arms that differ from the model", "what happens after the scenarios end"}) {
      verdict.not_checked.emplace_back(what);
    }
  }
  add_unchecked_contacts(study_.scenarios, verdict);
  verdict.not_checked.insert(verdict.not_checked.end(), never_checked().begin(), never_checked().end());
  add_assumptions(study_.scenarios, study_.stepper, verdict);
  add_controller_assumption(study_.scenarios, result.best.gains, verdict);
  verdict.notes = loosened(study_.thresholds);
  if (!result.passed_over.empty()) verdict.notes.push_back(result.passed_over);
  if (study_.given) verdict.notes.push_back(given_note(study_));
  for (const ComparedSet& set : outcome_.sets)
    add_shake_notes(set.results, &set == &outcome_.sets[1] ? "" : set.name + " gains", verdict);
  add_bounds_note(study_, result.best.gains, verdict);
}

}  // namespace armtune::internal
