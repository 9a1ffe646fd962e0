#pragma once
// A criterion of a Pareto front: the study's objective, or the worst value of a metric over its scenarios.

#include <optional>
#include <string>

#include "tuner/study/study.hpp"

namespace armtune::internal {

struct Criterion {
  std::optional<Metric> metric;  ///< empty: the study's objective

  /// Returns "objective" or the metric's name.
  std::string name() const;
  std::string unit() const;
  bool larger_is_better() const;
};

/// Returns the criterion called "objective", or called like a metric that is a goal. Throws InputError for
/// other names.
Criterion criterion_from_name(const std::string& name);

/// Returns the objective, or the metric's worst value over the scenarios that it applies to (see applies()),
/// in the metric's unit. It is NaN if a scenario did not give it, or if it applies to none. e: has one result
/// per scenario.
double value(const Criterion& criterion, const Evaluation& e, const std::vector<Scenario>& scenarios);

/// Returns the value with the sign for which less is better.
double cost(const Criterion& criterion, const Evaluation& e, const std::vector<Scenario>& scenarios);

}  // namespace armtune::internal
