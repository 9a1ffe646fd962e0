#pragma once
// Computes the objective and the constraints of a study from the metrics of simulated scenarios. The
// objective is relative to the start gains, which score 1.

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tuner/study/corner.hpp"
#include "tuner/study/evaluation.hpp"
#include "tuner/study/hopeless.hpp"

namespace armtune::internal {

/// A term of the objective: weight * mean over scenarios of the metric's score relative to its value with the
/// start gains (see term_score).
struct ObjectiveTerm {
  Metric metric = Metric::kPositionMax;  ///< one that is a goal
  double weight = 1.0;
  double floor = 0.0;                  ///< smallest reference, in the metric's unit
  std::vector<std::size_t> scenarios;  ///< indices into the study's scenarios; the metric applies to each
};

/// A user's own objective, in place of terms. It is computed from one result for each of the study's
/// scenarios, without corners. Less is better. It is called only if every scenario completed, by one thread
/// at a time.
using OwnObjective = std::function<double(const std::vector<RolloutResult>&)>;

/// A bound that must hold in every listed scenario.
struct Constraint {
  Metric metric = Metric::kJointVelocityMaxRatio;
  bool upper = true;            ///< true: at_most; false: at_least
  std::optional<double> limit;  ///< in the metric's unit; none: the start gains' own value
  std::vector<std::size_t> scenarios;
  Hopeless hopeless = {};  ///< condition to abandon a rollout, if the metric applies
  /// Set for the constraint of a margin: the demand on its corner rollouts, in place of a metric. `scenarios`
  /// are then the corners.
  std::optional<MarginDemand> margin = std::nullopt;
};

class Objective {
 public:
  /// scenarios: those that are simulated, corners included. start: results of the start gains, one per
  /// scenario. A default `hopeless` is ignored in a scenario where it would abandon the start's own rollout.
  /// Throws InputError, with `where` in front, if the start gains give no reference:
  /// - a scenario did not complete (corners may fail);
  /// - a term has no reference above zero, neither its metric's value nor its floor;
  /// - the metric of a constraint with the limit `start` has no value;
  /// - a value of `hopeless` in the study would abandon the start's own rollout;
  /// - `own` gives no number above zero.
  Objective(std::vector<ObjectiveTerm> terms, std::vector<Constraint> constraints,
            const std::vector<Scenario>& scenarios, const std::vector<RolloutResult>& start,
            const std::string& where, OwnObjective own = {});

  /// Sets objective, constraints, violation, feasible and status of `e` from its results. A scenario that did
  /// not complete makes it infeasible and scores a finite penalty, more than any scenario that did complete.
  /// The penalty is larger the earlier the scenario ended. For a hopeless one it is also larger the farther
  /// the constraints were broken.
  void judge(Evaluation& e) const;

  /// Returns the limits at which a candidate's rollouts are abandoned, per simulated scenario. They are not
  /// meant for the start's own rollouts.
  const std::vector<EndLimits>& end_limits() const { return end_limits_; }

  const std::vector<ObjectiveTerm>& terms() const { return terms_; }
  const std::vector<Constraint>& constraints() const { return constraints_; }
  /// Returns the limit of constraint c in scenario s (index into the study's).
  double limit(std::size_t c, std::size_t s) const;
  /// Returns a name such as "joint_velocity/max_ratio <= 0.9".
  std::string constraint_name(std::size_t c) const;
  /// Returns the number of values in Evaluation::constraints: one per constraint and one for completing.
  std::size_t constraint_count() const { return constraints_.size() + 1; }

 private:
  /// Returns 0 if the rollout completed, else 1 .. 2: larger the earlier it ended. For a hopeless rollout it
  /// is also larger the farther its constraints were broken. A diverged one counts as broken without limit.
  double incompleteness(const RolloutResult& result, std::size_t s) const;
  /// Returns 0 .. 1: by how much, relative to its limit, the worst constraint that can be hopeless is broken.
  double how_far(const RolloutResult& result, std::size_t s) const;
  double reference(const ObjectiveTerm& term, std::size_t s) const {
    return std::max(term.floor, start_[s][term.metric]);
  }
  /// Returns the score of a term in one scenario, relative to the start.
  double score(const ObjectiveTerm& term, const RolloutResult& result, std::size_t s) const;
  /// Returns by how much constraint c is broken in one scenario, in natural units; below zero where it holds.
  double excess(std::size_t c, const RolloutResult& result, std::size_t s) const;
  /// Returns the excess relative to the limit, at most kLargestRatio.
  double relative_excess(std::size_t c, double excess, std::size_t s) const;
  void set_end_limits(const std::vector<Scenario>& scenarios, const std::string& where);

  /// Returns the user's own objective, relative to the start.
  double own_score(const Evaluation& e) const;
  /// Returns the results that the user's own objective is given: those that are not of corners.
  std::vector<RolloutResult> of_scenarios(const std::vector<RolloutResult>& results) const;

  std::vector<ObjectiveTerm> terms_;
  OwnObjective own_;
  double own_start_ = 1.0;
  std::vector<Constraint> constraints_;
  std::vector<std::vector<bool>> judged_;  ///< [constraint][scenario]: true if listed and the metric applies
  std::vector<EndLimits> end_limits_;      ///< [scenario]
  std::vector<Scenario> corners_;          ///< [scenario]: all scenarios; read for corners only
  std::vector<bool> pushed_;               ///< [scenario]: a corner, which counts for its margin only
  std::vector<double> durations_;
  double weights_ = 0.0;  ///< sum over all terms
  std::vector<Metrics> start_;
};

/// Returns the limits at which rollouts are abandoned during a search. There are none before the start gains
/// have made the objective.
inline std::vector<EndLimits> end_limits(const std::optional<Objective>& objective) {
  return objective ? objective->end_limits() : std::vector<EndLimits>{};
}

}  // namespace armtune::internal
