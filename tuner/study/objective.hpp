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

/// A term of the objective. It is the weight times the mean of the metric's score (term_score.hpp) over the
/// scenarios. The score is relative to the metric's value with the start gains, the reference.
struct ObjectiveTerm {
  Metric metric = Metric::kPositionMax;  ///< a metric with a direction: larger or smaller is better
  double weight = 1.0;
  double floor = 0.0;                  ///< the reference is at least this; in the metric's unit
  std::vector<std::size_t> scenarios;  ///< indices into the study's scenarios; the metric applies to each
};

/// A user's own objective, in place of terms. Its argument has one result for each of the study's scenarios,
/// without corners (corner.hpp). It must return a number above zero; smaller numbers are better. It is called
/// only if every scenario completed, by one thread at a time.
using OwnObjective = std::function<double(const std::vector<RolloutResult>&)>;

/// A limit of a metric that must be kept in every listed scenario.
struct Constraint {
  Metric metric = Metric::kJointVelocityMaxRatio;
  bool upper = true;            ///< true: at_most (upper limit); false: at_least (lower limit)
  std::optional<double> limit;  ///< in the metric's unit; none: the metric's value with the start gains
  std::vector<std::size_t> scenarios;
  Hopeless hopeless = {};  ///< value of the metric at which a search abandons a rollout
  /// Set only if the constraint demands a stability margin. It then replaces the metric and the limit, and
  /// `scenarios` lists the corners.
  std::optional<MarginDemand> margin = std::nullopt;
};

class Objective {
 public:
  /// scenarios: all simulated scenarios, corners included. start: results of the start gains, one per
  /// scenario. A constraint with Hopeless::Kind::kAuto abandons no rollout in a scenario where it would
  /// abandon the rollout of the start gains. Throws InputError if the start gains give no reference. The
  /// place of the error is `where`, with a key path such as "constraints/1/at_most". The start gains give no
  /// reference in these cases:
  /// - a scenario did not complete (corners may fail);
  /// - neither the metric's value nor the floor of a term is above zero;
  /// - a constraint has the metric's value with the start gains as its limit, but there is no such value;
  /// - a value of `hopeless` in the study would abandon the rollout of the start gains;
  /// - `own` does not return a number above zero.
  Objective(std::vector<ObjectiveTerm> terms, std::vector<Constraint> constraints,
            const std::vector<Scenario>& scenarios, const std::vector<RolloutResult>& start,
            const std::string& where, OwnObjective own = {});

  /// Sets objective, constraints, violation, feasible, completed and reason of `e` from its results. If a
  /// scenario other than a corner did not complete, `e` is infeasible. In each term, a penalty then takes the
  /// place of the scenario's score. The penalty is finite, and larger than the score of any completed
  /// scenario. It is larger if the rollout ended earlier. For a hopeless rollout it is also larger if
  /// constraints are broken farther. The user's own objective is replaced by a constant penalty.
  void judge(Evaluation& e) const;

  /// Returns the limits at which a candidate's rollouts are abandoned, one entry per simulated scenario. Do
  /// not use them for the rollouts of the start gains.
  const std::vector<EndLimits>& end_limits() const { return end_limits_; }

  const std::vector<ObjectiveTerm>& terms() const { return terms_; }
  const std::vector<Constraint>& constraints() const { return constraints_; }
  /// Returns the limit of constraint c in simulated scenario s.
  double limit(std::size_t c, std::size_t s) const;
  /// Returns the value with which a term scores 1 in simulated scenario s.
  double reference(const ObjectiveTerm& term, std::size_t s) const {
    return std::max(term.floor, start_[s][term.metric]);
  }
  /// Returns a name such as "joint_velocity/max_ratio <= 0.9".
  std::string constraint_name(std::size_t c) const;
  /// Returns the number of values in Evaluation::constraints: one for each constraint, and a last one that is
  /// satisfied if every scenario completed.
  std::size_t constraint_count() const { return constraints_.size() + 1; }

 private:
  /// Returns 0 if the rollout completed. Otherwise returns a value from 1 to 2, which increases if the
  /// rollout ended earlier. It also increases with how_far() if the rollout is hopeless. For other failures,
  /// such as a diverged rollout, 1 is used in place of how_far().
  double incompleteness(const RolloutResult& result, std::size_t s) const;
  /// Returns a measure, from 0 to 1, of how far the constraints are broken. It is w / (1 + w), where w is the
  /// largest relative excess among the constraints that can be hopeless. It is 0 if none of them is broken.
  double how_far(const RolloutResult& result, std::size_t s) const;
  /// Returns the score of a term in one scenario, relative to the start.
  double score(const ObjectiveTerm& term, const RolloutResult& result, std::size_t s) const;
  /// Returns by how much constraint c is broken in one scenario, in the metric's unit. A value of zero or
  /// less means that the constraint is satisfied.
  double excess(std::size_t c, const RolloutResult& result, std::size_t s) const;
  /// Returns the excess divided by the limit, at most kLargestRatio.
  double relative_excess(std::size_t c, double excess, std::size_t s) const;
  void set_judged(const std::vector<Scenario>& scenarios, const std::string& where);
  void set_end_limits(const std::vector<Scenario>& scenarios, const std::string& where);

  /// Returns the user's own objective divided by its value with the start gains.
  double own_score(const Evaluation& e) const;
  /// Returns the results for the user's own objective, that is, all except those of corners.
  std::vector<RolloutResult> of_scenarios(const std::vector<RolloutResult>& results) const;

  std::vector<ObjectiveTerm> terms_;
  OwnObjective own_;
  double own_start_ = 1.0;
  std::vector<Constraint> constraints_;
  std::vector<std::vector<bool>> judged_;  ///< [constraint][scenario]: true if listed and the metric applies
  std::vector<EndLimits> end_limits_;      ///< [scenario]
  std::vector<Scenario> corners_;          ///< [scenario]: every simulated scenario; used for corners only
  std::vector<bool> pushed_;               ///< [scenario]: true for a corner; only its margin uses it
  std::vector<double> durations_;
  double weights_ = 0.0;  ///< sum over all terms
  std::vector<Metrics> start_;
};

/// Returns the limits at which rollouts are abandoned during a search. There are none as long as there is no
/// objective, that is, before the start gains were simulated.
inline std::vector<EndLimits> end_limits(const std::optional<Objective>& objective) {
  return objective ? objective->end_limits() : std::vector<EndLimits>{};
}

}  // namespace armtune::internal
