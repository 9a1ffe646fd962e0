#pragma once
// Objective and constraints of a study: metrics over scenarios, relative to the start gains.

#include <optional>
#include <string>
#include <vector>

#include "tuner/study/evaluation.hpp"

namespace armtune {

/// weight * mean over scenarios of metric / metric of the start gains.
struct ObjectiveTerm {
  Metric metric = Metric::kPositionMax;
  double weight = 1.0;
  double floor = 0.0;                  ///< smallest reference, in the metric's unit
  std::vector<std::size_t> scenarios;  ///< indices into the study's scenarios
};

/// A bound that must hold in every listed scenario.
struct Constraint {
  Metric metric = Metric::kJointVelocityMaxRatio;
  bool upper = true;            ///< at_most, else at_least
  std::optional<double> limit;  ///< in the metric's unit; none: the start gains' own value
  std::vector<std::size_t> scenarios;
};

class Objective {
 public:
  /// start: results of the start gains, one per scenario. Throws InputError, with `where` in front, if they
  /// give no reference: a scenario did not complete, or a term's
  /// metric has no value or no positive one, or that of a constraint `start` none.
  Objective(std::vector<ObjectiveTerm> terms, std::vector<Constraint> constraints,
            const std::vector<Scenario>& scenarios, const std::vector<RolloutResult>& start,
            const std::string& where);

  /// Sets objective, constraints, violation, feasible and status of `e` from its results. A scenario that did
  /// not complete makes it infeasible and scores a finite penalty that grows with how early it ended.
  void judge(Evaluation& e) const;

  const std::vector<ObjectiveTerm>& terms() const { return terms_; }
  const std::vector<Constraint>& constraints() const { return constraints_; }
  /// Limit of constraint c in scenario s (index into the study's).
  double limit(std::size_t c, std::size_t s) const;
  /// "joint_velocity/max_ratio <= 0.9"
  std::string constraint_name(std::size_t c) const;
  /// Number of values in Evaluation::constraints: one per constraint and one for completing.
  std::size_t constraint_count() const { return constraints_.size() + 1; }

 private:
  /// 0 if completed, else 1 .. 2: larger the earlier it ended.
  double incompleteness(const RolloutResult& result, std::size_t s) const;

  std::vector<ObjectiveTerm> terms_;
  std::vector<Constraint> constraints_;
  std::vector<std::vector<bool>> judged_;  ///< [constraint][scenario]: listed there, and the metric applies
  std::vector<double> durations_;
  std::vector<Metrics> start_;
};

}  // namespace armtune
