#include "tuner/study/objective.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "armtune/error.hpp"
#include "sim/rollout/applies.hpp"
#include "tuner/study/term_score.hpp"

namespace armtune::internal {
namespace {

/// Smallest score of a term in a scenario that did not complete. It is above the score of any completed one.
constexpr double kIncompletePenalty = 2.0 * kLargestRatio;

double scale_of(double bound) {
  return bound != 0.0 ? std::abs(bound) : 1.0;
}

/// Returns the place of an entry of a list in the study: the term or the constraint with this index.
InputPlace entry_of(const std::string& where, const char* list, std::size_t index, const char* key = "") {
  return {where, 0, fmt::format("{}/{}{}", list, index, key)};
}

/// Throws InputError because the start gains' value cannot be the reference of the term at `place`.
[[noreturn]] void refuse_reference(const ObjectiveTerm& term, const std::string& scenario, double start,
                                   InputPlace place) {
  const std::string what =
      std::isfinite(start)
          ? fmt::format(
                "{} of the start gains in {} is {}, but it must be above zero, because the objective "
                "is relative to it",
                name(term.metric), scenario, start)
          : fmt::format("the start gains give no value of {} in {}, but the objective is relative to it",
                        name(term.metric), scenario);
  throw InputError(
      std::move(place),
      fmt::format("{}. Use other start gains, leave the scenario out of the term's 'scenarios', or "
                  "give the term a 'floor', the smallest value that serves as reference [{}]{}",
                  what, field(term.metric).unit,
                  larger_is_better(term.metric) ? ". A constraint with 'at_least' needs no reference" : ""))
      .with_value(std::isfinite(start) ? fmt::to_string(start) : "", "above zero");
}

}  // namespace

Objective::Objective(std::vector<ObjectiveTerm> terms, std::vector<Constraint> constraints,
                     const std::vector<Scenario>& scenarios, const std::vector<RolloutResult>& start,
                     const std::string& where, OwnObjective own)
    : terms_(std::move(terms)), own_(std::move(own)), constraints_(std::move(constraints)) {
  for (std::size_t s = 0; s < scenarios.size(); ++s) {
    pushed_.push_back(scenarios[s].pushed);
    if (start[s].status != RolloutStatus::kCompleted && !scenarios[s].pushed) {
      throw InputError(
          InputPlace{where, 0, "gains"},
          InputFault{
              .problem = fmt::format(
                  "the start gains do not complete {}: {}. The objective is relative to the start gains; "
                  "give gains that complete every scenario (with 'robust', on every random arm too)",
                  scenarios[s].name, start[s].reason),
              .value = scenarios[s].name});
    }
    durations_.push_back(scenarios[s].duration);
    start_.push_back(start[s].metrics);
  }
  corners_ = scenarios;
  if (own_) {
    own_start_ = own_(of_scenarios(start));
    if (!(std::isfinite(own_start_) && own_start_ > 0.0)) {
      throw InputError(
          InputPlace{where, 0, "objective"},
          fmt::format("the objective of the start gains is {}, but it must be a number above zero, because "
                      "all objectives are divided by it",
                      own_start_))
          .with_value(fmt::to_string(own_start_), "a number above zero");
    }
  }
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    const ObjectiveTerm& term = terms_[t];
    weights_ += term.weight;
    for (const std::size_t s : term.scenarios) {
      const double of_start = reference(term, s);
      if (!(std::isfinite(of_start) && of_start > 0.0)) {
        refuse_reference(term, scenarios[s].name, start_[s][term.metric], entry_of(where, "objective", t));
      }
    }
  }
  set_judged(scenarios, where);
  set_end_limits(scenarios, where);
}

void Objective::set_judged(const std::vector<Scenario>& scenarios, const std::string& where) {
  for (std::size_t c = 0; c < constraints_.size(); ++c) {
    const Constraint& constraint = constraints_[c];
    std::vector<bool>& judged = judged_.emplace_back(scenarios.size(), false);
    for (const std::size_t s : constraint.scenarios) {
      judged[s] = constraint.margin.has_value() || applies(constraint.metric, scenarios[s]);
      if (constraint.margin) continue;
      if (judged[s] && !constraint.limit && std::isnan(start_[s][constraint.metric])) {
        throw InputError(
            entry_of(where, "constraints", c, constraint.upper ? "/at_most" : "/at_least"),
            fmt::format("the start gains give no {} in {}, so the limit 'start' has no value; give a number",
                        name(constraint.metric), scenarios[s].name))
            .with_value("start", "a number");
      }
    }
  }
}

void Objective::set_end_limits(const std::vector<Scenario>& scenarios, const std::string& where) {
  end_limits_.resize(scenarios.size());
  for (std::size_t c = 0; c < constraints_.size(); ++c) {
    const Constraint& constraint = constraints_[c];
    if (constraint.margin || constraint.hopeless.kind == Hopeless::Kind::kNever) continue;
    const bool stated = constraint.hopeless.kind == Hopeless::Kind::kFrom;
    for (const std::size_t s : constraint.scenarios) {
      if (!judged_[c][s]) continue;
      const auto value = stated ? std::optional(constraint.hopeless.value)
                                : default_hopeless(constraint.metric, constraint.upper, limit(c, s));
      if (!value) continue;
      const EndLimit end{constraint.metric, *value};
      if (!end.reached_by(start_[s][constraint.metric])) {
        end_limits_[s].push_back(end);
      } else if (stated) {
        const double of_start = start_[s][constraint.metric];
        throw InputError(
            entry_of(where, "constraints", c, "/hopeless"),
            fmt::format("{} of the start gains in {} is {}, but 'hopeless' begins at {}, so the rollout of "
                        "the start gains would be abandoned; set 'hopeless' to a worse value, or to 'never'",
                        name(constraint.metric), scenarios[s].name, of_start, *value))
            .with_value(fmt::to_string(*value),
                        fmt::format("{} {}, or never", constraint.upper ? "above" : "below", of_start));
      }
    }
  }
}

double Objective::how_far(const RolloutResult& result, std::size_t s) const {
  double worst = 0.0;
  for (std::size_t c = 0; c < constraints_.size(); ++c) {
    const Constraint& constraint = constraints_[c];
    if (constraint.margin || !judged_[c][s] || !can_be_hopeless(constraint.metric, constraint.upper))
      continue;
    const double bound = limit(c, s);
    const double v = result.metrics[constraint.metric];
    const double relative = (constraint.upper ? v - bound : bound - v) / scale_of(bound);
    if (relative > worst) worst = std::min(relative, kLargestRatio);
  }
  return worst / (1.0 + worst);
}

double Objective::incompleteness(const RolloutResult& result, std::size_t s) const {
  if (result.status == RolloutStatus::kCompleted) return 0.0;
  const double left = 1.0 - std::clamp(result.end_time / durations_[s], 0.0, 1.0);
  const double far = result.status == RolloutStatus::kHopeless ? how_far(result, s) : 1.0;
  return 1.0 + left * (1.0 + far) / 2.0;
}

double Objective::limit(std::size_t c, std::size_t s) const {
  const Constraint& constraint = constraints_[c];
  if (constraint.margin) return 0.0;
  return constraint.limit ? *constraint.limit : start_[s][constraint.metric];
}

std::string Objective::constraint_name(std::size_t c) const {
  const Constraint& constraint = constraints_[c];
  if (constraint.margin) {
    return fmt::format("margin {} at {}", name(constraint.margin->kind), constraint.margin->value);
  }
  return fmt::format("{} {} {}", name(constraint.metric), constraint.upper ? "<=" : ">=",
                     constraint.limit ? fmt::format("{}", *constraint.limit) : "start");
}

double Objective::score(const ObjectiveTerm& term, const RolloutResult& result, std::size_t s) const {
  const double incomplete = incompleteness(result, s);
  const double value = result.metrics[term.metric];
  return incomplete > 0.0 || !std::isfinite(value) ? kIncompletePenalty * std::max(1.0, incomplete)
                                                   : term_score(term.metric, value, reference(term, s));
}

double Objective::excess(std::size_t c, const RolloutResult& result, std::size_t s) const {
  if (constraints_[c].margin) return missing_to_hold(result, corners_[s]);
  const double bound = limit(c, s);
  const double v = result.metrics[constraints_[c].metric];
  const double g = constraints_[c].upper ? v - bound : bound - v;
  return std::isfinite(g) ? g : scale_of(bound) * std::max(1.0, incompleteness(result, s));
}

double Objective::relative_excess(std::size_t c, double excess, std::size_t s) const {
  return std::min(excess / scale_of(limit(c, s)), kLargestRatio);
}

std::vector<RolloutResult> Objective::of_scenarios(const std::vector<RolloutResult>& results) const {
  std::vector<RolloutResult> own;
  for (std::size_t s = 0; s < results.size(); ++s) {
    if (!pushed_[s]) own.push_back(results[s]);
  }
  return own;
}

double Objective::own_score(const Evaluation& e) const {
  const std::vector<RolloutResult> results = of_scenarios(e.results);
  const bool completed = std::all_of(results.begin(), results.end(), [](const RolloutResult& result) {
    return result.status == RolloutStatus::kCompleted;
  });
  if (!completed) return kIncompletePenalty;
  const double value = own_(results);
  if (!(std::isfinite(value) && value > 0.0)) {
    throw FailedError(
        fmt::format("the objective of a candidate is {}; it must be a number above zero", value));
  }
  return std::min(value / own_start_, kLargestRatio);
}

void Objective::judge(Evaluation& e) const {
  double sum = 0.0;
  for (const ObjectiveTerm& term : terms_) {
    double mean = 0.0;
    for (const std::size_t s : term.scenarios) mean += score(term, e.results[s], s);
    sum += term.weight * mean / static_cast<double>(term.scenarios.size());
  }
  e.objective = own_ ? own_score(e) : sum / weights_;

  e.constraints.assign(constraint_count(), 0.0);
  e.relative.assign(constraint_count(), 0.0);
  e.violation = 0.0;
  for (std::size_t c = 0; c < constraints_.size(); ++c) {
    const Constraint& constraint = constraints_[c];
    double worst = -HUGE_VAL;
    double relative = -HUGE_VAL;
    for (const std::size_t s : constraint.scenarios) {
      // The metric does not apply, such as the clearance in a scenario without obstacles.
      if (!judged_[c][s]) continue;
      const double g = excess(c, e.results[s], s);
      worst = std::max(worst, g);
      relative = std::max(relative, relative_excess(c, g, s));
    }
    if (!std::isfinite(worst)) continue;
    e.constraints[c] = worst;
    e.relative[c] = relative;
    e.violation += std::max(0.0, relative);
  }
  double incomplete = 0.0;
  e.completed = true;
  e.reason.clear();
  for (std::size_t s = 0; s < e.results.size(); ++s) {
    if (pushed_[s]) continue;
    const double here = incompleteness(e.results[s], s);
    if (here > 0.0 && std::exchange(e.completed, false)) e.reason = e.results[s].reason;
    incomplete += here;
    // The part that was not simulated could have broken every constraint. Therefore the candidate ranks
    // behind all that completed every scenario.
    if (here > 0.0) e.violation += kLargestRatio * static_cast<double>(constraints_.size());
  }
  e.constraints.back() = incomplete;
  e.relative.back() = incomplete;
  e.violation += incomplete;
  e.feasible = e.violation <= 0.0;
}

}  // namespace armtune::internal
