#include "tuner/verdict/search_checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <mutex>
#include <optional>

#include "tuner/robustness/monte_carlo.hpp"
#include "tuner/verdict/assumptions.hpp"
#include "tuner/verdict/first_breach.hpp"
#include "tuner/verdict/yield_check.hpp"
#include "tuner/workers/parallel.hpp"

namespace armtune::internal {
namespace {

/// Returns words for how a constraint's value is computed: over the scenario's own arm, or over many arms
/// with the study's risk measure.
std::string judged_by(const Study& study) {
  if (!study.robust) return "value over the whole scenario";
  return fmt::format("value: {} of {} arms",
                     risk_measure_names()[static_cast<std::size_t>(study.robust->measure)],
                     arms(*study.robust));
}

/// Returns the failed check of constraint c at the point `best`. It names the scenario with the largest
/// violation, and the joint and the time of the first breach there.
Check broken_constraint(const Study& study, const Evaluation& best, const Objective& objective,
                        std::size_t c) {
  const Constraint& constraint = objective.constraints()[c];
  Check check{CheckKind::kConstraints, false};
  check.detail = objective.constraint_name(c);
  check.unit = field(constraint.metric).unit;
  double largest = -HUGE_VAL;
  std::size_t worst = 0;
  for (const std::size_t s : constraint.scenarios) {
    const double value = best.results[s].metrics[constraint.metric];
    const double excess = constraint.upper ? value - objective.limit(c, s) : objective.limit(c, s) - value;
    if (!(excess > largest)) continue;
    largest = excess;
    worst = s;
  }
  const Scenario& scenario = study.scenarios[worst];
  check.scenario = scenario.name;
  check.value = best.results[worst].metrics[constraint.metric];
  check.threshold = objective.limit(c, worst);
  // A rollout can be ended at a limit only if going beyond the limit makes the metric worse: at_most where
  // less is better, at_least where more is better.
  if (constraint.upper == larger_is_better(constraint.metric)) return check;
  if (const auto breach = first_breach(study, scenario, best.gains, {constraint.metric, check.threshold})) {
    check.arm = breach->arm;
    check.joint = breach->joint;
    check.time = breach->time;
    check.detail += " (first broken at this time); " + judged_by(study);
  }
  return check;
}

/// Returns the failed check of constraint c, which demands a stability margin. The simulation at this margin
/// gives the reason of the failure.
Check broken_margin(const Study& study, const Evaluation& best, const Objective& objective, std::size_t c) {
  const Constraint& constraint = objective.constraints()[c];
  Check check{CheckKind::kConstraints, false};
  check.detail = objective.constraint_name(c);
  MarginOptions how;
  how.stepper = study.stepper;
  const std::atomic<bool> never{false};
  for (const Scenario& scenario : study.scenarios) {
    const MarginDemand& asked = *constraint.margin;
    const auto reason =
        failure_at(asked.kind, demanded_value(asked, scenario), scenario, best.gains, how, never);
    if (!reason || reason->holds()) continue;
    check.scenario = scenario.name;
    check.joint = reason->joint;
    check.time = reason->time;
    check.detail += fmt::format(" ({})", reason->text);
    break;
  }
  return check;
}

CheckKind check_of(MarginKind kind) {
  switch (kind) {
    case MarginKind::kTorqueDelay:
      return CheckKind::kTorqueDelay;
    case MarginKind::kGainFactor:
      return CheckKind::kGainFactor;
    case MarginKind::kControlRate:
      return CheckKind::kControlRate;
    default:
      return CheckKind::kVelocityNoise;
  }
}

}  // namespace

SearchOutcome outcome_of(const TuneResult& result) {
  if (result.best.x == result.start.x || !better(result.best, result.start)) return SearchOutcome::kStart;
  return result.best.feasible ? SearchOutcome::kTuned : SearchOutcome::kLeastViolation;
}

const char* name(SearchOutcome outcome) {
  switch (outcome) {
    case SearchOutcome::kTuned:
      return "tuned";
    case SearchOutcome::kStart:
      return "start (kept)";
    case SearchOutcome::kLeastViolation:
      return "least violation";
  }
  return "";
}

void add_search_checks(const Study& study, const TuneResult& result, const Objective& objective,
                       SimulationVerdict& verdict) {
  const Evaluation& best = result.best;
  Check constraints{CheckKind::kConstraints};
  double worst = 0.0;
  std::optional<std::size_t> in_the_way;
  for (std::size_t c = 0; c < objective.constraints().size(); ++c) {
    if (!(best.relative[c] > worst)) continue;
    worst = best.relative[c];
    in_the_way = c;
  }
  if (in_the_way) {
    constraints = objective.constraints()[*in_the_way].margin
                      ? broken_margin(study, best, objective, *in_the_way)
                      : broken_constraint(study, best, objective, *in_the_way);
  }
  if (!best.completed && constraints.passed) {
    constraints.passed = false;
    constraints.detail = best.reason;
  }
  verdict.checks.push_back(std::move(constraints));
  Check improvement{CheckKind::kBetterThanStart};
  improvement.passed = outcome_of(result) == SearchOutcome::kTuned;
  if (!improvement.passed) {
    improvement.detail = outcome_of(result) == SearchOutcome::kStart
                             ? "nothing better than the start gains was found"
                             : "no feasible gains were found";
  } else if (!result.start.feasible && best.objective > 1.0) {
    verdict.notes.push_back(fmt::format(
        "the tuned gains keep the constraints, which the start gains break; their objective is {:.3g} times "
        "that of the start gains",
        best.objective));
  }
  verdict.checks.push_back(std::move(improvement));
}

void add_bounds_note(const Study& study, const Gains& gains, SimulationVerdict& verdict) {
  std::vector<std::string> names;
  for (const Parameter& p : study.space.free) {
    if (on_bound(p, value(gains, p.entry))) names.push_back(p.entry.name);
  }
  if (names.empty()) return;
  verdict.notes.push_back(
      fmt::format("{} of {} gains lie on a bound of the study: {}. Wider bounds may be better, if the robot "
                  "tolerates such gains",
                  names.size(), study.space.free.size(), fmt::join(names, ", ")));
}

bool add_margin_checks(const Study& study, const Gains& gains, const DeepCheckOptions& options,
                       const std::atomic<bool>& stop, SimulationVerdict& verdict) {
  const std::size_t scenarios = study.scenarios.size();
  const std::size_t jobs = kMarginCount * scenarios;
  std::vector<std::optional<LoopFailure>> why(jobs);
  MarginOptions how;
  how.stepper = study.stepper;
  std::mutex mutex;
  std::size_t done = 0;
  const auto demand = [&study](std::size_t m) {
    const MarginThreshold& margin = margin_thresholds()[m];
    return MarginDemand{margin.kind, study.thresholds.*margin.value};
  };
  parallel_for(jobs, options.workers, stop, [&](std::size_t, std::size_t job) {
    const Scenario& scenario = study.scenarios[job % scenarios];
    const MarginDemand asked = demand(job / scenarios);
    why[job] = failure_at(asked.kind, demanded_value(asked, scenario), scenario, gains, how, stop);
    const std::lock_guard lock(mutex);
    if (options.progress) options.progress("margins at their thresholds", ++done, jobs);
  });
  if (stop) return false;
  for (std::size_t m = 0; m < kMarginCount; ++m) {
    const MarginDemand asked = demand(m);
    Check check{check_of(asked.kind)};
    check.threshold = asked.value;
    if (asked.kind == MarginKind::kVelocityNoise && !has_noise(study.scenarios)) {
      verdict.not_checked.emplace_back("the noise margin (no scenario has velocity noise)");
      continue;
    }
    for (std::size_t s = 0; s < scenarios && check.passed; ++s) {
      const LoopFailure& reason = *why[m * scenarios + s];
      if (reason.holds()) continue;
      check.passed = false;
      check.joint = reason.joint;
      check.time = reason.time;
      check.scenario = study.scenarios[s].name;
      check.detail =
          fmt::format("with {} at {:.4g} {}, the closed loop fails ({})", name(asked.kind),
                      demanded_value(asked, study.scenarios[s]), field(asked.kind).unit, reason.text);
    }
    verdict.checks.push_back(std::move(check));
  }
  return true;
}

void add_nominal_checks(const std::vector<Scenario>& scenarios, const std::vector<Margin>& margins,
                        SimulationVerdict& verdict) {
  for (std::size_t m = 0; m < kMarginCount; ++m) {
    const auto kind = static_cast<MarginKind>(m);
    const std::optional<Margin> smallest = least(scenarios, margins, kind);
    if (!smallest) continue;
    Check check{check_of(kind), smallest->stands.has_value(), smallest->scenario};
    check.value = smallest->stands.value_or(NAN);
    check.threshold = smallest->nominal;
    check.unit = field(kind).unit;
    if (!check.passed)
      check.detail = fmt::format(
          "the closed loop fails without any change of delay, gains, rate or noise ({})", smallest->reason);
    verdict.checks.push_back(std::move(check));
  }
}

bool add_yield_check(const Study& study, const Gains& gains, const DeepCheckOptions& options,
                     const std::atomic<bool>& stop, SimulationVerdict& verdict) {
  MonteCarloOptions how;
  how.perturbation = study.robust ? study.robust->perturbation : default_perturbation(study.scenarios);
  how.samples = static_cast<std::uint64_t>(study.thresholds.arms);
  how.stepper = study.stepper;
  how.workers = options.workers;
  if (study.robust && study.robust->seed == how.seed) ++how.seed;  // other arms than those of the search
  if (study.stepper != Stepper::kReference) how.engine = Engine::kNative;
  how.progress = [&](std::size_t done, std::size_t all) {
    if (options.progress) options.progress("random arms", done, all);
  };
  const auto samples = monte_carlo(study.scenarios, gains, how, stop);
  if (stop || samples.empty()) return false;
  verdict.checks.push_back(yield_check(study.scenarios, samples, study.thresholds.yield));
  verdict.assumes.push_back(spread_text(study.robust ? "the study's" : "the default", how.perturbation));
  add_engine_assumption(how.engine, kArmsThatKept, verdict);
  return true;
}

}  // namespace armtune::internal
