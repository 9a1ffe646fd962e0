#pragma once
// Objective and constraints of a study: metrics over scenarios, relative to the start gains.

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tuner/study/corner.hpp"
#include "tuner/study/evaluation.hpp"
#include "tuner/study/hopeless.hpp"

namespace armtune::internal {

/// weight * mean over scenarios of the metric's score against its value with the start gains (see
/// term_score).
struct ObjectiveTerm {
  Metric metric = Metric::kPositionMax;  ///< one that is a goal
  double weight = 1.0;
  double floor = 0.0;                  ///< smallest reference, in the metric's unit
  std::vector<std::size_t> scenarios;  ///< indices into the study's scenarios; the metric applies to each
};

/// A user's own objective, in place of terms: from one result for each of the study's scenarios, corners left
/// out. Less is better. It is asked where every scenario completed, by one thread at a time.
using OwnObjective = std::function<double(const std::vector<RolloutResult>&)>;

/// A bound that must hold in every listed scenario.
struct Constraint {
  Metric metric = Metric::kJointVelocityMaxRatio;
  bool upper = true;            ///< at_most, else at_least
  std::optional<double> limit;  ///< in the metric's unit; none: the start gains' own value
  std::vector<std::size_t> scenarios;
  Hopeless hopeless = {};  ///< from where on a rollout ends, where the metric applies
  /// Of a margin: what its corner rollouts demand, in place of a metric. `scenarios` are the corners then.
  std::optional<MarginDemand> margin = std::nullopt;
};

class Objective {
 public:
  /// scenarios: those that are simulated, corners included. start: results of the start gains, one per
  /// scenario. Throws InputError, with `where` in front, if they give no reference: a scenario did not
  /// complete, or a term's metric has no value or no positive one, that of a constraint `start` none, or one
  /// is hopeless by a value that the study gives, or `own` gives no positive number. By default a constraint
  /// is never hopeless in a scenario where the start would be.
  Objective(std::vector<ObjectiveTerm> terms, std::vector<Constraint> constraints,
            const std::vector<Scenario>& scenarios, const std::vector<RolloutResult>& start,
            const std::string& where, OwnObjective own = {});

  /// Sets objective, constraints, violation, feasible and status of `e` from its results. A scenario that did
  /// not complete makes it infeasible and scores a finite penalty that grows with how early it ended and, of
  /// a hopeless one, with how far its constraints were broken by then: more than any that did complete.
  void judge(Evaluation& e) const;

  /// Limits at which a candidate's rollouts are abandoned, per scenario of the study. Not for the start's
  /// own.
  const std::vector<EndLimits>& end_limits() const { return end_limits_; }

  const std::vector<ObjectiveTerm>& terms() const { return terms_; }
  const std::vector<Constraint>& constraints() const { return constraints_; }
  /// Limit of constraint c in scenario s (index into the study's).
  double limit(std::size_t c, std::size_t s) const;
  /// "joint_velocity/max_ratio <= 0.9"
  std::string constraint_name(std::size_t c) const;
  /// Number of values in Evaluation::constraints: one per constraint and one for completing.
  std::size_t constraint_count() const { return constraints_.size() + 1; }

 private:
  /// 0 if completed, else 1 .. 2: larger the earlier it ended, and of a hopeless one the farther it had gone;
  /// one that diverged went as far as can be.
  double incompleteness(const RolloutResult& result, std::size_t s) const;
  /// 0 .. 1: by how much, relative to its limit, the worst of the constraints that can be hopeless is broken.
  double how_far(const RolloutResult& result, std::size_t s) const;
  double reference(const ObjectiveTerm& term, std::size_t s) const {
    return std::max(term.floor, start_[s][term.metric]);
  }
  /// Of one scenario, relative to the start.
  double score(const ObjectiveTerm& term, const RolloutResult& result, std::size_t s) const;
  /// By how much constraint c is broken in one scenario, in natural units; below zero where it holds.
  double excess(std::size_t c, const RolloutResult& result, std::size_t s) const;
  /// The same over its limit, as far as it counts.
  double relative_excess(std::size_t c, double excess, std::size_t s) const;
  void set_end_limits(const std::vector<Scenario>& scenarios, const std::string& where);

  /// The user's own objective, relative to the start.
  double own_score(const Evaluation& e) const;
  /// What it is given.
  std::vector<RolloutResult> of_scenarios(const std::vector<RolloutResult>& results) const;

  std::vector<ObjectiveTerm> terms_;
  OwnObjective own_;
  double own_start_ = 1.0;
  std::vector<Constraint> constraints_;
  std::vector<std::vector<bool>> judged_;  ///< [constraint][scenario]: listed there, and the metric applies
  std::vector<EndLimits> end_limits_;      ///< [scenario]
  std::vector<Scenario> corners_;          ///< [scenario]: where it is a corner
  std::vector<bool> pushed_;               ///< [scenario]: a corner, which counts for its margin alone
  std::vector<double> durations_;
  double weights_ = 0.0;  ///< of all terms
  std::vector<Metrics> start_;
};

/// Where rollouts end while a search goes on: nowhere before the start gains made the objective.
inline std::vector<EndLimits> end_limits(const std::optional<Objective>& objective) {
  return objective ? objective->end_limits() : std::vector<EndLimits>{};
}

}  // namespace armtune::internal
