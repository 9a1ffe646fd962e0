#pragma once
// Defines the criteria of a Pareto front. A criterion is the study's objective, or the worst value of a
// metric over the study's scenarios.

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

/// Returns the criterion with this name: "objective", or the name of a metric for which either larger or
/// smaller values are better. Throws InputError for other names.
Criterion criterion_from_name(const std::string& name);

/// Returns the criterion's value: the objective, or the metric's worst value in the metric's unit. The worst
/// value is taken over the scenarios to which the metric applies (see applies()). It is NaN if the metric has
/// no value in one of these scenarios, or if it applies to none. e: has one result per scenario.
double value(const Criterion& criterion, const Evaluation& e, const std::vector<Scenario>& scenarios);

/// Returns the criterion's value, negated if larger values are better. Smaller costs are always better.
double cost(const Criterion& criterion, const Evaluation& e, const std::vector<Scenario>& scenarios);

}  // namespace armtune::internal
