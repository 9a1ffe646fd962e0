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

/// Returns the first check that failed as a text; empty if none failed.
std::string failed(const SimulationVerdict& verdict) {
  const auto found = std::find_if(verdict.checks.begin(), verdict.checks.end(),
                                  [](const Check& check) { return !check.passed; });
  return found == verdict.checks.end() ? std::string() : to_text(*found);
}

void append(const SimulationVerdict& more, SimulationVerdict& verdict) {
  verdict.checks.insert(verdict.checks.end(), more.checks.begin(), more.checks.end());
  for (const std::string& assumed : more.assumes) add_once(assumed, verdict.assumes);
}

}  // namespace

DeepCheckOptions TuneSession::deep_checks() const {
  DeepCheckOptions how;
  how.workers = settings_.workers;
  how.progress = [&observer = observer_](const std::string& what, std::size_t done, std::size_t all) {
    progress_of(observer, "checks: " + what)(done, all);
  };
  return how;
}

void TuneSession::extend_scenarios(const Gains& gains) {
  made_.endured = endure(
      study_.scenarios, [&gains](const Scenario&) { return gains; },
      {study_.thresholds.minutes, study_.stepper, settings_.workers,
       progress_of(observer_, "checks: extended scenarios")},
      context_.stop);
  observer_.part_is_over();
}

std::string TuneSession::fault_of(const Gains& gains) {
  made_ = {gains_yaml(gains, {}), {}, {}};
  if (study_.thresholds.minutes > 0.0) {
    extend_scenarios(gains);
    if (made_.endured.size() < study_.scenarios.size()) return {};  // interrupted
    SimulationVerdict endurance;
    add_endurance_checks(made_.endured, study_.thresholds, "", endurance);
    if (std::string fault = failed(endurance); !fault.empty()) return fault;
  }
  SimulationVerdict yield;
  const bool whole = add_yield_check(study_, gains, deep_checks(), context_.stop, yield);
  observer_.part_is_over();
  if (!whole) return {};
  made_.yield = std::move(yield);
  return failed(*made_.yield);
}

/// Checks the yield. Results that the search has asked for already are used again.
void TuneSession::check_yield() {
  const Gains& gains = outcome_.result.best.gains;
  if (made_.yield && made_.gains == gains_yaml(gains, {})) {
    append(*made_.yield, outcome_.verdict);
  } else if (!add_yield_check(study_, gains, deep_checks(), context_.stop, outcome_.verdict)) {
    outcome_.verdict.not_checked.emplace_back("arms that differ from the model (interrupted)");
  }
  observer_.part_is_over();
}

void TuneSession::check_endurance() {
  SimulationVerdict& verdict = outcome_.verdict;
  if (study_.thresholds.minutes <= 0.0) {
    verdict.not_checked.emplace_back("endurance (its threshold is zero minutes)");
    return;
  }
  const Gains& gains = outcome_.result.best.gains;
  if (made_.endured.size() < study_.scenarios.size() || made_.gains != gains_yaml(gains, {}))
    extend_scenarios(gains);
  observer_.extended(made_.endured);
  if (made_.endured.size() < study_.scenarios.size()) {
    verdict.not_checked.emplace_back("endurance (interrupted)");
    return;
  }
  add_endurance_checks(made_.endured, study_.thresholds, "", verdict);
}

/// Makes every check of the search's result: constraints, improvement over the start, and the arm's own
/// limits in the study's scenarios. If the result was analysed, also checks margins, random arms and
/// endurance. Otherwise lists these under "Not checked".
void TuneSession::check(bool analysed) {
  const TuneResult& result = outcome_.result;
  SimulationVerdict& verdict = outcome_.verdict;
  add_search_checks(study_, result, *outcome_.objective, verdict);
  add_rollout_checks(outcome_.sets[1].results, "", verdict);
  add_contact_checks(study_.scenarios, outcome_.sets[1].results, "", verdict);
  if (analysed) {
    const Gains& gains = result.best.gains;
    if (!add_margin_checks(study_, gains, deep_checks(), context_.stop, verdict))
      verdict.not_checked.emplace_back("stability margins (interrupted)");
    if (!add_rotor_check(study_, gains, deep_checks(), context_.stop, verdict))
      verdict.not_checked.emplace_back("rotor inertia that differs from the estimate (interrupted)");
    check_yield();
    check_endurance();
  } else {
    for (const char* what :
         {"stability margins", "arms that differ from the model", "what happens after the scenarios end"}) {
      verdict.not_checked.emplace_back(what);
    }
    add_unchecked_rotors(study_.scenarios, verdict);
  }
  add_unchecked_contacts(study_.scenarios, verdict);
  verdict.not_checked.insert(verdict.not_checked.end(), never_checked().begin(), never_checked().end());
  add_assumptions(study_.scenarios, study_.stepper, verdict);
  add_controller_assumption(study_.scenarios, result.best.gains, verdict);
  const std::vector<std::string> loose = loosened(study_.thresholds);
  verdict.notes.insert(verdict.notes.end(), loose.begin(), loose.end());
  verdict.notes.insert(verdict.notes.end(), task_warnings_.begin(), task_warnings_.end());
  if (!result.passed_over.empty()) verdict.notes.push_back(result.passed_over);
  if (study_.given) verdict.notes.push_back(given_note(study_));
  for (const ComparedSet& set : outcome_.sets) {
    if (&set != &outcome_.sets[1]) add_shake_notes(set.results, set.name + " gains", verdict);
  }
  add_bounds_note(study_, result.best.gains, verdict);
}

}  // namespace armtune::internal
